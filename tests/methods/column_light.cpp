#include "tests/methods/column_light.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <thread>

#include "core/methods/path_trace/tracer.h"
#include "core/scene/angle.h"
#include "core/scene/parameters.h"

namespace airlight::test {

using physics::vec3;

namespace {

constexpr double kFlatRadius = 1e6;  // km, radius of a planet that is as good as flat
constexpr double kCloudBase = 0.2;   // km

Scene column_scene(const ColumnCase& given) {
  Scene scene;
  scene.planet.ground_radius = kFlatRadius;
  Cloud cloud;
  cloud.kind = CloudKind::volume;
  cloud.contents = given.cloud;
  cloud.base = given.cloud->lowest - 0.5 * given.cloud->dz;
  cloud.top = cloud.base + given.cloud->dz * given.cloud->nz;
  cloud.single_scattering_albedo = given.albedo;
  cloud.phase = CloudPhase::henyey_greenstein;
  cloud.phase_g = given.g;
  scene.planet.atmosphere_height = 2.0 * cloud.top;
  scene.clouds = {cloud};
  Medium none;
  none.name = "none";
  none.density.profile = DensityProfile::constant;
  scene.media = {none};
  scene.sun.elevation = radians_from_degrees(given.sun_elevation);
  scene.sun.azimuth = radians_from_degrees(270.0);
  return scene;
}

Part column_part(const Scene& scene) {
  Air air(scene.media, scene.planet);
  Things things(scene, {});
  return {scene, std::move(air), std::move(things)};
}

// Sums of one quantity.
struct ColumnSum {
  double mean = 0.0;
  double variance = 0.0;  // of the mean
};

class ColumnTracer {
 public:
  ColumnTracer(const ColumnCase& given, int samples, unsigned seed)
      : given_(given),
        part_(column_part(column_scene(given))),
        tracer_(part_, nullptr, seed, 0, parameter::kNoLimit),
        samples_(samples),
        seed_(seed),
        cosine_(std::sin(radians_from_degrees(given.sun_elevation))),
        base_(given.cloud->lowest - 0.5 * given.cloud->dz),
        top_(base_ + given.cloud->dz * given.cloud->nz) {
    sun_ = physics::Physics().direction_from_angles(part_.scene.sun.elevation, part_.scene.sun.azimuth);
  }

  int columns() const { return given_.cloud->nx * given_.cloud->ny; }
  ColumnSum zenith(int column) {
    return measure(column, 2, [&](Random& random, WalkNumbers& numbers, FlightPlan& plan) {
      return std::numbers::pi * arriving(place(column, top_, random), {0.0, -1.0, 0.0}, numbers, plan) / cosine_;
    });
  }
  // Where the sunlight ends up that falls on the columns at the top, in shares of what falls on one of them.
  struct Fate {
    std::vector<double> reflected;
    std::vector<double> transmitted;
    std::vector<double> absorbed;
    std::array<double, 3> sums{};     // over all light
    std::array<double, 3> squares{};  // of each path's shares
    double count = 0.0;

    explicit Fate(int columns)
        : reflected(static_cast<std::size_t>(columns)),
          transmitted(static_cast<std::size_t>(columns)),
          absorbed(static_cast<std::size_t>(columns)) {}
  };

  // Follows light that falls on this column.
  void follow_from(int column, Fate& fate) const {
    Random random(seed_ + 1000, static_cast<std::uint64_t>(column), 7);
    FlightPlan plan;
    for (int k = 0; k < samples_; ++k) {
      WalkNumbers numbers(seed_, static_cast<std::uint64_t>(column) * 8 + 7, static_cast<std::uint64_t>(k / kBatch),
                          k % kBatch);
      std::array<double, 3> shares{};
      const Walk::Left left =
          tracer_.follow(place(column, top_, random), -sun_, numbers, plan, [&](vec3 at, double lost) {
            fate.absorbed[column_of(at)] += lost;
            shares[2] += lost;
          });
      const bool up = dot(left.place, left.direction) > 0.0;
      shares[up ? 0 : 1] = left.share;
      (up ? fate.reflected : fate.transmitted)[column_of(way_out(left, up ? top_ : base_))] += left.share;
      for (std::size_t i = 0; i < 3; ++i) {
        fate.sums[i] += shares[i];
        fate.squares[i] += shares[i] * shares[i];
      }
      fate.count += 1.0;
    }
  }

 private:
  double arriving(vec3 at, vec3 direction, WalkNumbers& numbers, FlightPlan& plan) const {
    return tracer_.arriving(at, direction, numbers, plan).x;
  }

  // A place in the column at altitude h.
  vec3 place(int column, double h, Random& random) const {
    const CloudFile& cloud = *given_.cloud;
    const double x = (column % cloud.nx + random.uniform() - 0.5 * cloud.nx) * cloud.dx;
    const int row = column / cloud.nx;
    const double y = (row + random.uniform() - 0.5 * cloud.ny) * cloud.dy;
    const double r = kFlatRadius + h;
    return normalize(vec3(x, kFlatRadius, -y)) * r;
  }

  // Where the light crosses a level, which is as good as a plane.
  static vec3 way_out(const Walk::Left& left, double h) {
    const double climbs = dot(normalize(left.place), left.direction);
    return left.place + left.direction * ((h + kFlatRadius - length(left.place)) / climbs);
  }

  std::size_t column_of(const vec3& at) const {
    const CloudFile& cloud = *given_.cloud;
    const auto cell = [](double place, double width, int count) {
      const double n = std::floor(place / width + 0.5 * count);
      return static_cast<std::size_t>(std::clamp(n - count * std::floor(n / count), 0.0, count - 1.0));
    };
    return cell(kFlatRadius * at.x / at.y, cloud.dx, cloud.nx) +
           static_cast<std::size_t>(cloud.nx) * cell(-kFlatRadius * at.z / at.y, cloud.dy, cloud.ny);
  }

  template <class Value>
  ColumnSum measure(int column, int quantity, Value value) {
    const auto pixel = static_cast<std::uint64_t>(column) * 8 + static_cast<std::uint64_t>(quantity);
    Random random(seed_ + 1000, pixel, 0);
    FlightPlan plan;
    double sum = 0.0;
    double squares = 0.0;
    for (int k = 0; k < samples_; ++k) {
      WalkNumbers numbers(seed_, pixel, static_cast<std::uint64_t>(k / kBatch), k % kBatch);
      const double x = value(random, numbers, plan);
      sum += x;
      squares += x * x;
    }
    const double mean = sum / samples_;
    return {mean, (squares / samples_ - mean * mean) / std::max(samples_ - 1, 1)};
  }

  const ColumnCase& given_;
  Part part_;
  PathTracer tracer_;
  int samples_;
  unsigned seed_;
  double cosine_;
  double base_;
  double top_;
  vec3 sun_;
};

}  // namespace

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::shared_ptr<CloudFile> step_cloud() {
  constexpr double kThick = 0.25;  // km
  auto cloud = std::make_shared<CloudFile>();
  cloud->nx = 32;
  cloud->ny = 1;
  cloud->nz = 1;
  cloud->dx = 0.5 / 32;
  cloud->dy = 0.5;
  cloud->dz = kThick;
  cloud->lowest = kCloudBase + 0.5 * kThick;
  cloud->in_cells = true;
  cloud->identity = "step";
  for (int i = 0; i < cloud->nx; ++i) {
    cloud->extinction.push_back(static_cast<float>((i < 16 ? 2.0 : 18.0) / kThick));
  }
  return cloud;
}

std::shared_ptr<CloudFile> column_cloud(int nx, int ny, const std::vector<double>& thickness,
                                        const std::vector<double>& depth) {
  auto cloud = std::make_shared<CloudFile>();
  const double highest = *std::ranges::max_element(thickness);
  cloud->nx = nx;
  cloud->ny = ny;
  cloud->nz = 128;
  cloud->dx = 0.03;
  cloud->dy = 0.03;
  cloud->dz = highest / cloud->nz;
  cloud->lowest = kCloudBase + 0.5 * cloud->dz;
  cloud->in_cells = true;
  cloud->identity = "columns";
  const std::size_t layer = thickness.size();
  cloud->extinction.resize(layer * static_cast<std::size_t>(cloud->nz));
  for (std::size_t c = 0; c < layer; ++c) {
    for (int k = 0; k < cloud->nz && thickness[c] > 0.0; ++k) {
      const double filled = std::clamp(thickness[c] / cloud->dz - k, 0.0, 1.0);
      cloud->extinction[c + layer * static_cast<std::size_t>(k)] = static_cast<float>(filled * depth[c] / thickness[c]);
    }
  }
  return cloud;
}

ColumnLight column_light(const ColumnCase& scene, int samples, int threads, unsigned seed) {
  ColumnTracer tracer(scene, samples, seed);
  const auto count = static_cast<std::size_t>(tracer.columns());
  ColumnLight light;
  light.zenith.resize(count);
  std::vector<double> variances(count);
  std::vector<ColumnTracer::Fate> fates(static_cast<std::size_t>(threads), ColumnTracer::Fate(tracer.columns()));
  std::atomic<std::size_t> next = 0;
  const auto work = [&](ColumnTracer::Fate& fate) {
    for (std::size_t k = next++; k < count; k = next++) {
      const int column = static_cast<int>(k);
      tracer.follow_from(column, fate);
      const ColumnSum zenith = tracer.zenith(column);
      light.zenith[k] = zenith.mean;
      variances[k] = zenith.variance;
    }
  };
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < fates.size(); ++k) {
    others.emplace_back([&, k] { work(fates[k]); });
  }
  work(fates[0]);
  for (std::thread& other : others) {
    other.join();
  }
  ColumnTracer::Fate all(tracer.columns());
  for (const ColumnTracer::Fate& fate : fates) {
    for (std::size_t k = 0; k < count; ++k) {
      all.reflected[k] += fate.reflected[k] / samples;
      all.transmitted[k] += fate.transmitted[k] / samples;
      all.absorbed[k] += fate.absorbed[k] / samples;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      all.sums[i] += fate.sums[i];
      all.squares[i] += fate.squares[i];
    }
    all.count += fate.count;
  }
  const auto error = [&](std::size_t i) {
    const double mean = all.sums[i] / all.count;
    return std::sqrt(std::max(all.squares[i] / all.count - mean * mean, 0.0) / all.count);
  };
  light.reflectance = all.reflected;
  light.transmittance = all.transmitted;
  light.absorptance = all.absorbed;
  light.reflectance_error = error(0);
  light.transmittance_error = error(1);
  light.absorptance_error = error(2);
  light.zenith_error = std::sqrt(std::accumulate(variances.begin(), variances.end(), 0.0)) / static_cast<double>(count);
  return light;
}

}  // namespace airlight::test
