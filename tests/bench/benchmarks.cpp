#include "tests/bench/benchmarks.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/air/scene_block.h"
#include "core/luts/luts.h"
#include "core/night/night.h"
#include "core/night/stars.h"
#include "core/post/stars.h"
#include "core/render/render.h"
#include "core/render/spans.h"
#include "tests/bench/scenes.h"
#include "tests/of_scene.h"

namespace airlight::bench {
namespace {

constexpr std::array<ImageSize, 3> kSizes{{{1280, 720}, {1920, 1080}, {3840, 2160}}};

// Least seconds of table passes, in place of --benchmark_min_time: on a GPU they are a hundredth of an iteration's
// time.
constexpr double kTablesMinTime = 0.02;

// User and system time of all threads so far: the real cost of a picture on a software device.
double cpu_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

// The plan's passes without copies from or to the host. A copy is no part of a pass, yet at 3840x2160 it takes longer
// than most passes, and a GPU that waits for it clocks down.
Plan without_copies(const Plan& plan) {
  Plan out;
  out.scene_data = plan.scene_data;
  for (const ImageDesc& image : plan.images()) out.add_image(image);
  for (BufferDesc buffer : plan.buffers()) {
    buffer.host_readable = false;
    if (buffer.name == "spans") buffer.key = "things in " + std::to_string(buffer.bytes) + " bytes";
    out.add_buffer(std::move(buffer));
  }
  for (const PassDesc& pass : plan.passes()) out.add_pass(pass);
  return out;
}

// Names of the passes whose results are kept from picture to picture.
std::set<std::string> table_passes(const Plan& plan) {
  const std::vector<bool> runs = passes_to_run(plan, [](ResourceId) { return true; });
  std::set<std::string> names;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i]) names.insert(pass_name(plan.passes()[i]));
  }
  return names;
}

using PassFilter = std::function<bool(const std::string& pass)>;

// Each iteration runs the next plan in turn; the time is that of the passes that the filter lets through.
void time_plans(benchmark::State& state, Executor& executor, std::span<const Plan> plans, const PassFilter& counted) {
  std::map<std::string, double> milliseconds;
  double cpu = 0.0;
  std::size_t turn = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    const double cpu_before = cpu_milliseconds();
    const RunResult result = executor.run(plans[turn]);
    cpu += cpu_milliseconds() - cpu_before;
    turn = (turn + 1) % plans.size();
    double all = 0.0;
    for (const PassTiming& pass : result.passes) {
      if (!counted(pass.name)) continue;
      milliseconds[pass.name] += pass.milliseconds;
      all += pass.milliseconds;
    }
    state.SetIterationTime(1e-3 * all);
  }
  for (const auto& [pass, sum] : milliseconds) {
    state.counters[pass + "_ms"] = benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
  }
  state.counters["cpu_ms"] = benchmark::Counter(cpu, benchmark::Counter::kAvgIterations);
}

void time_picture(benchmark::State& state, Executor& executor, const Scene& scene, bool whole_frame, bool& warm) {
  RenderRequest request;
  request.bloom = whole_frame;
  request.bloom_picture = false;
  request.gpu_tone = whole_frame;
  const std::array plans{without_copies(plan_for(scene, request))};
  if (!warm) {
    executor.run(plans[0]);  // pipelines and tables
    warm = true;
  }
  time_plans(state, executor, plans, [](const std::string&) { return true; });
}

// A scene for timing tables. Its picture shows no disc, which may bring a table of its own. It is seen from space,
// where most methods work pixel by pixel; this uncounted work keeps a GPU's clock up. With tables alone the GPU would
// be idle between runs and clock down by a factor of two and more. A software device does not need this and gets one
// pixel.
Scene for_tables(const SkyMethod& method, const Scene& from, bool is_cpu) {
  Scene scene = rendered_by(method, from, is_cpu ? ImageSize{1, 1} : kSizes.back());
  scene.sun.disc.visible = false;
  scene.camera.altitude = 2.0 * scene.planet.atmosphere_height;
  scene.camera.pitch = -0.25 * std::numbers::pi;
  return scene;
}

// Two planets in turn whose grounds differ by a hair, so that an executor that keeps nothing else makes all tables
// anew.
void time_tables(benchmark::State& state, Executor& executor, const SkyMethod& method, const Scene& from, bool& warm) {
  const Scene scene = for_tables(method, from, executor.device().is_cpu);
  Scene other = scene;
  other.planet.ground_albedo[0] += 1e-4;
  const std::array plans{without_copies(plan_for(scene, {})), without_copies(plan_for(other, {}))};
  const std::set<std::string> names = table_passes(plans[0]);
  if (!warm) executor.run(plans[0]);
  warm = true;
  executor.run(plans[1]);  // discards the first plan's tables, whatever ran last
  time_plans(state, executor, plans, [&](const std::string& pass) { return names.contains(pass); });
}

// Registers `body(state)`. Its failure is recorded for this benchmark and the session.
template <class Body>
benchmark::internal::Benchmark& register_one(Session& session, const std::string& name, Body body) {
  return *benchmark::RegisterBenchmark(name.c_str(),
                                       [&session, body](benchmark::State& state) mutable {
                                         try {
                                           body(state);
                                         } catch (const std::exception& error) {
                                           session.failed = true;
                                           state.SkipWithError(error.what());
                                         }
                                       })
              ->UseManualTime()
              ->MeasureProcessCPUTime()
              ->Unit(benchmark::kMillisecond);
}

void register_picture(Session& session, const SkyMethod& method, const NamedScene& named, bool whole_frame) {
  for (const ImageSize size : kSizes) {
    const std::string name = std::string(whole_frame ? "frame/" : "sky/") + std::string(method.info.name) + '/' +
                             std::string(named.name) + '/' + std::to_string(size.width) + 'x' +
                             std::to_string(size.height);
    const Scene scene = rendered_by(method, named.scene, size);
    register_one(session, name, [&session, scene, whole_frame, warm = false](benchmark::State& state) mutable {
      time_picture(state, session.pictures(), scene, whole_frame, warm);
    });
  }
}

// Distances of things all over the picture, from 20 m at its foot to 60 km at its top.
std::vector<float> distances(ImageSize size) {
  std::vector<float> all;
  for (int y = 0; y < size.height; ++y) {
    const double up = 1.0 - (y + 0.5) / size.height;
    all.insert(all.end(), static_cast<std::size_t>(size.width), static_cast<float>(0.02 * std::pow(3000.0, up)));
  }
  return all;
}

// The same distances as a list of pixels.
std::vector<Span> list_of(const std::vector<float>& distances, ImageSize size) {
  std::vector<Span> spans;
  spans.reserve(distances.size());
  for (const float distance : distances) {
    const std::size_t i = spans.size();
    const auto width = static_cast<std::size_t>(size.width);
    spans.push_back({static_cast<std::uint16_t>(i % width), static_cast<std::uint16_t>(i / width), distance});
  }
  return spans;
}

// A way to the air before things: a march along each ray, or the aerial volume, made for each picture.
struct AirQuality {
  std::string name;  // "march-48", "volume-16", "volume-16-listed"
  bool volume;
  std::string key;
  int value;
  bool listed = false;  // listed one by one, as for a picture with few things; else row by row
};

const std::vector<AirQuality>& air_qualities() {
  static const std::vector<AirQuality> all = [] {
    std::vector<AirQuality> list;
    for (const int steps : {12, 24, 48, 96}) {
      list.push_back({"march-" + std::to_string(steps), false, "steps", steps});
    }
    for (const int slices : {8, 16, 32, 64}) {
      list.push_back({"volume-" + std::to_string(slices), true, "aerial_slices", slices});
    }
    list.push_back({"march-48-listed", false, "steps", 48, true});
    list.push_back({"volume-16-listed", true, "aerial_slices", 16, true});
    return list;
  }();
  return all;
}

// Mean of |a - b| / max(b, a thousandth of b's mean), channels pooled.
double light_error(const std::vector<AirTo>& a, const std::vector<AirTo>& exact) {
  const double values = 3.0 * static_cast<double>(exact.size());
  double mean = 0.0;
  for (const AirTo& air : exact) {
    for (const float value : air.radiance) mean += value / values;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double b = exact[i].radiance[c];
      sum += std::abs(a[i].radiance[c] - b) / std::max({b, 1e-3 * mean, 1e-30}) / values;
    }
  }
  return sum;
}

// Error against the march in 768 steps, before 96x54 things of the same picture.
double air_error(Executor& executor, Scene scene, const AirQuality& quality) {
  scene.image = {96, 54};
  const std::vector<float> ends = distances(scene.image);
  const std::vector<AirTo> found = air_to_all(executor, scene, ends, {quality.volume, {}});
  scene.render.parameters.insert_or_assign("steps", 768);
  return light_error(found, air_to_all(executor, scene, ends));
}

void time_air(benchmark::State& state, Executor& executor, const SkyMethod& method, const Scene& scene,
              const AirQuality& quality, double& error) {
  const Part part = part_of(scene);
  Plan plan;
  plan.scene_data = device_scene_bytes(part.air, scene);
  const std::vector<float> ends = distances(scene.image);
  const std::vector<Span> list = quality.listed ? list_of(ends, scene.image) : std::vector<Span>();
  method.add_span_passes(plan, part, quality.listed ? Spans{.list = list} : Spans{.rows = ends}, {quality.volume, {}});
  const std::array plans{without_copies(plan)};
  if (error < 0.0) {
    error = air_error(executor, scene, quality);
    executor.run(plans[0]);  // pipelines and tables
  }
  time_plans(state, executor, plans, [](const std::string&) { return true; });
  state.counters["error_percent"] = 100.0 * error;
}

void register_air(Session& session, const SkyMethod& method, const NamedScene& named) {
  for (const ImageSize size : kSizes) {
    for (const AirQuality& quality : air_qualities()) {
      Scene scene = rendered_by(method, named.scene, size);
      scene.render.parameters.insert_or_assign(quality.key, quality.value);
      if (quality.volume && (method.has_volume == nullptr || !method.has_volume(scene))) {
        continue;
      }
      const std::string name = "air/" + std::string(method.info.name) + '-' + quality.name + '/' +
                               std::string(named.name) + '/' + std::to_string(size.width) + 'x' +
                               std::to_string(size.height);
      register_one(session, name, [&session, &method, scene, &quality, error = -1.0](benchmark::State& state) mutable {
        time_air(state, session.pictures(), method, scene, quality, error);
      });
    }
  }
}

void register_tables(Session& session, const SkyMethod& method) {
  std::set<std::string> airs;
  for (const NamedScene& named : scenes()) {
    const Scene scene = for_tables(method, named.scene, true);
    const bool is_new = airs.insert(table_key(air_of(scene), "air", {1, 1})).second;
    if (!is_new || table_passes(plan_for(scene, {})).empty()) continue;
    const std::string name = "tables/" + std::string(method.info.name) + '/' + std::string(named.name);
    register_one(session, name, [&session, &method, &named, warm = false](benchmark::State& state) mutable {
      time_tables(state, session.tables(), method, named.scene, warm);
    }).MinTime(kTablesMinTime);
  }
}

}  // namespace

Executor& Session::pictures() {
  if (!pictures_) pictures_.emplace(DeviceOptions{});
  return *pictures_;
}

Executor& Session::tables() {
  if (!tables_) tables_.emplace(DeviceOptions{.kept_bytes_max = 0});
  return *tables_;
}

// On the host: reading the catalogue, and placing, bending and sharing the light of all stars to magnitude 6 among the
// pixels of the whole sky.
void register_stars() {
  benchmark::RegisterBenchmark("stars/read", [](benchmark::State& state) {
    for (const auto& once : state) {
      (void)once;
      benchmark::DoNotOptimize(read_stars(star_table()));
    }
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("stars/1280x720", [](benchmark::State& state) {
    Scene scene = scenes().front().scene;
    scene.stars = Stars{6.0};
    scene.camera.projection = Projection::equirectangular;
    scene.image = kSizes.front();
    const Air air = air_of(scene);
    physics::Physics p = geometry_of(scene);
    for (const auto& once : state) {
      (void)once;
      benchmark::DoNotOptimize(
          star_pixels(p, scene, night_of(scene, {{air}, {}}), {0, 0, scene.image.width, scene.image.height}));
    }
  })->Unit(benchmark::kMillisecond);
}

void register_benchmarks(Session& session) {
  register_stars();
  for (const SkyMethod& method : methods()) {
    if (method.add_passes == nullptr) continue;
    for (const NamedScene& named : scenes()) register_picture(session, method, named, false);
    register_picture(session, method, scenes().front(), true);
    if (method.add_span_passes != nullptr) {
      for (const NamedScene& named : scenes()) register_air(session, method, named);
    }
  }
  for (const SkyMethod& method : methods()) {
    if (method.add_passes != nullptr) register_tables(session, method);
  }
}

}  // namespace airlight::bench
