#include "core/methods/analytic_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "core/air/scene_block.h"
#include "core/plan/bytes.h"

namespace airlight {
namespace {

using physics::AnalyticMedium;
using physics::Physics;
using physics::vec3;

constexpr int kShells = 400;
constexpr unsigned int kSteps = 12;  // along a gathering ray, and from each step toward the sun
constexpr unsigned int kColumnSteps = 64;
constexpr unsigned int kDirections = physics::kMultipleScatteringDirections;
constexpr double kBlack = 1e-30;  // stands for black in the logarithm
// A base lower than this share of the mean altitude counts as none: a plain exponential cut off at the top has none.
constexpr double kLeastBase = 0.1;
constexpr double kSunStep = 0.01;  // of the sun's zenith cosine, for the slope

// Columns of density 1 in thin shells, dense near the ground, where the air is.
class Profile {
 public:
  explicit Profile(Physics& p) : media_(p.medium_count()) {
    for (int k = 0; k < kShells; ++k) {
      const double low = edge(p, k);
      const double high = edge(p, k + 1);
      altitudes_.push_back(0.5 * (low + high));
      Row row{};
      for (unsigned int i = 0; i < media_; ++i) {
        row[i] = p.density(p.density_profile(i), p.medium(i), altitudes_.back()) * (high - low);
      }
      columns_.push_back(row);
    }
  }

  AnalyticMedium equivalent(unsigned int i) const {
    double column = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double z = altitudes_[k];
      column += columns_[k][i];
      first += columns_[k][i] * z;
      second += columns_[k][i] * z * z;
    }
    AnalyticMedium a;
    a.column = column;
    a.scale_height = 1.0;
    if (column > 0.0) {
      const double mean = first / column;
      const double base = mean - std::sqrt(std::max(second / column - mean * mean, 1e-6));
      a.base = base > kLeastBase * mean ? base : 0.0;
      a.scale_height = mean - a.base;
    }
    return a;
  }

  // Between two altitudes: the share of medium j above a point, as the mean over medium i. One half where either is
  // absent.
  double share_above(unsigned int i, unsigned int j, double low, double high) const {
    double all_i = 0.0;
    double all_j = 0.0;
    double mean = 0.0;  // of j's column above. Columns are not multiplied: of two small ones nothing would be left
    for (std::size_t k = columns_.size(); k-- > 0;) {
      if (altitudes_[k] > low && altitudes_[k] < high) {
        all_i += columns_[k][i];
        const double part = all_i > 0.0 ? columns_[k][i] / all_i : 0.0;
        mean += part * (all_j + 0.5 * columns_[k][j] - mean);
        all_j += columns_[k][j];
      }
    }
    return all_i > 0.0 && all_j > 0.0 ? mean / all_j : 0.5;
  }

  // The altitude above which this share of the scattering above h stands; h where there is no scattering.
  double altitude_of_share(const Physics& p, double h, double share) const {
    const std::vector<double> part = scattering_above(p, h);
    const double all = std::accumulate(part.begin(), part.end(), 0.0);
    double above = 0.0;
    for (std::size_t k = part.size(); k-- > 0;) {
      above += part[k];
      if (above > share * all) {
        return altitudes_[k];
      }
    }
    return h;
  }

  // Mean altitude of that scattering, above h.
  double mean_height(const Physics& p, double h) const {
    const std::vector<double> part = scattering_above(p, h);
    const double all = std::accumulate(part.begin(), part.end(), 0.0);
    const double moment = std::inner_product(part.begin(), part.end(), altitudes_.begin(), 0.0);
    return all > 0.0 ? moment / all - h : 1.0;
  }

 private:
  using Row = std::array<double, static_cast<std::size_t>(physics::kMaxMedia)>;

  std::vector<double> scattering_above(const Physics& p, double h) const {
    std::vector<double> part;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      double sum = 0.0;
      for (unsigned int i = 0; i < media_; ++i) {
        const vec3 s = p.medium(i).scattering;
        sum += columns_[k][i] * (s.x + s.y + s.z);
      }
      part.push_back(altitudes_[k] > h ? sum : 0.0);
    }
    return part;
  }

  static double edge(Physics& p, int k) {
    const double u = static_cast<double>(k) / kShells;
    return p.scene.planet.atmosphere_height * u * u;
  }

  unsigned int media_;
  std::vector<double> altitudes_;
  std::vector<Row> columns_;
};

// Optical depth along the horizontal over that along the vertical; 1 where there is no air. It is limited to that of an
// exponential of a metre over the largest planet, sqrt(pi R / 2 H): beyond this the vertical steps have missed the air.
vec3 horizon_mass(Physics& p, double h) {
  constexpr double kMost = 1.25e5;
  const vec3 level = p.optical_depth_to_top(p.scene.planet, h, 0.0, kColumnSteps);
  const vec3 up = p.optical_depth_to_top(p.scene.planet, h, 1.0, kColumnSteps);
  return physics::min(physics::max(level / physics::max(up, vec3(kBlack)), vec3(1.0)), vec3(kMost));
}

// Logarithm of isotropic multiple scattering [H20] at one place, as in the table of `march`.
vec3 log_diffuse(Physics& p, double h, double mu_sun) {
  vec3 second_order(0.0);
  vec3 transfer(0.0);
  for (unsigned int k = 0; k < kDirections; ++k) {
    const Physics::Ray ray = p.gather_ray(p.scene.planet, h, mu_sun, k);
    const Physics::ScatteringGather gather = p.gather_scattering(p.scene.planet, p.scene.sun, ray, kSteps);
    second_order = second_order + gather.second_order / kDirections;
    transfer = transfer + gather.transfer / kDirections;
  }
  return physics::log(physics::max(p.sum_of_orders(second_order, transfer), vec3(kBlack)));
}

physics::AnalyticDiffuse diffuse_light(Physics& p, const Profile& profile) {
  const double top = p.scene.planet.atmosphere_height;
  const double h = std::min(p.scene.camera.altitude, top);
  const double mu_sun = p.scene.sun.direction.y;
  const double low = profile.altitude_of_share(p, h, 0.75);
  const double high = profile.altitude_of_share(p, h, 0.25);
  const vec3 at_low = log_diffuse(p, low, mu_sun);
  const vec3 at_high = log_diffuse(p, high, mu_sun);
  physics::AnalyticDiffuse d;
  // The straight line through the quarters, over the share that stands higher.
  d.near = at_low * 1.5 - at_high * 0.5;
  d.far = at_high * 1.5 - at_low * 0.5;
  d.ground = log_diffuse(p, 0.0, mu_sun);
  d.slope = (log_diffuse(p, low, mu_sun + kSunStep) - log_diffuse(p, low, mu_sun - kSunStep)) / (2.0 * kSunStep);
  return d;
}

vec3 log_sky_irradiance(Physics& p) {
  physics::SunData sun = p.scene.sun;
  sun.irradiance = vec3(1.0);
  const double mu_sun = sun.direction.y;
  vec3 sum(0.0);
  for (unsigned int k = 0; k < physics::kGroundIrradianceDirections; ++k) {
    const Physics::Ray ray = p.irradiance_ray(p.scene.planet, mu_sun, k);
    sum = sum + p.analytic_exponential(p.scene.planet, sun, ray, mu_sun).radiance * p.irradiance_weight();
  }
  return physics::log(physics::max(sum, vec3(kBlack)));
}

}  // namespace

Physics make_analytic_physics(const Part& part) {
  Physics p = formulas_of(part.air, part.scene);
  p.sun_steps = kSteps;
  const Profile profile(p);
  const double top = p.scene.planet.atmosphere_height;
  const double h = std::min(p.scene.camera.altitude, top);
  physics::AnalyticData& data = p.analytic;
  for (unsigned int i = 0; i < p.medium_count(); ++i) {
    data.media[i] = profile.equivalent(i);
    for (unsigned int j = 0; j < p.medium_count(); ++j) {
      data.above[i * physics::kMaxMedia + j] = profile.share_above(i, j, h, top);
      data.below[i * physics::kMaxMedia + j] = profile.share_above(i, j, 0.0, h);
    }
  }
  data.horizon_mass = horizon_mass(p, h);
  data.lit_height = profile.mean_height(p, h);
  data.diffuse = diffuse_light(p, profile);
  data.diffuse.irradiance = log_sky_irradiance(p);
  return p;
}

std::vector<std::byte> analytic_bytes(const physics::AnalyticData& data) {
  constexpr std::size_t kNumbers = sizeof data / sizeof(double);
  static_assert(sizeof data == kNumbers * sizeof(double));
  std::array<double, kNumbers> wide{};
  std::memcpy(wide.data(), &data, sizeof data);
  std::array<float, kNumbers> narrow{};
  std::ranges::transform(wide, narrow.begin(), [](double x) { return static_cast<float>(x); });
  return bytes_of(narrow);
}

}  // namespace airlight
