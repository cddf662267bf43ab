#include "core/chart/timing.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <span>
#include <string_view>

#include "core/choice/cost.h"
#include "core/methods/method.h"
#include "core/methods/scene_air.h"

namespace airlight::chart {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Sky {
  Plan plan;
  BufferId radiance;
  std::set<std::string, std::less<>> table_passes;  // those whose output is kept for later pictures
  std::string table_keys;
};

Sky sky_of(const Scene& scene) {
  Sky sky;
  sky.plan.scene_data = device_scene_bytes(air_of(scene), scene);
  sky.radiance = find_method(scene.render.method)->add_passes(sky.plan, scene, air_of(scene), View{}).radiance;
  const std::vector<bool> runs = passes_to_run(sky.plan, [&](ResourceId id) { return choice::is_table(sky.plan, id); });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i]) {
      sky.table_passes.insert(pass_name(sky.plan.passes()[i]));
    }
  }
  for (const ImageDesc& image : sky.plan.images()) {
    sky.table_keys += image.key;
  }
  return sky;
}

double milliseconds_of(const RunResult& result, const Sky& sky, bool tables) {
  double sum = 0.0;
  for (const PassTiming& pass : result.passes) {
    sum += sky.table_passes.contains(pass.name) == tables ? pass.milliseconds : 0.0;
  }
  return sum;
}

// Another planet by a hair: the same shaders on tables that are not there yet.
Scene neighbour(Scene scene, int n) {
  auto radius = static_cast<float>(scene.planet.ground_radius);
  for (int i = 0; i < n; ++i) {
    radius = std::nextafter(radius, std::numeric_limits<float>::infinity());
  }
  scene.planet.ground_radius = static_cast<double>(radius);
  return scene;
}

double time_tables(Executor& executor, const Scene& scene) {
  constexpr int kBakes = 3;
  std::vector<double> bakes;
  for (int n = 1; n <= kBakes; ++n) {
    const Sky sky = sky_of(neighbour(scene, n));
    bakes.push_back(milliseconds_of(executor.run(sky.plan), sky, true));
  }
  return median(std::move(bakes));
}

}  // namespace

double process_cpu_ms() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(use.ru_utime) + ms(use.ru_stime);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Timing time_on_device(Executor& executor, const Scene& scene, const PixelSet& pixels, const TimingRules& rules,
                      TableTimes& tables) {
  const Sky sky = sky_of(scene);
  const Clock::time_point begin = Clock::now();
  executor.run(sky.plan);
  const double first_ms = ms_since(begin);

  Timing timing;
  std::vector<double> cpu;
  std::vector<double> device;
  std::vector<double> wall;
  double spent_s = 0.0;
  const auto enough = [&] {
    const auto runs = static_cast<int>(wall.size());
    const int fewest = !wall.empty() && wall.front() > 1e3 * rules.long_s ? 1 : rules.fewest_runs;
    return runs >= rules.most_runs || (runs >= fewest && spent_s >= rules.enough_s);
  };
  while (!enough()) {
    const double cpu_before = process_cpu_ms();
    const Clock::time_point start = Clock::now();
    const RunResult result = executor.run(sky.plan);
    wall.push_back(ms_since(start));
    cpu.push_back(process_cpu_ms() - cpu_before);
    device.push_back(milliseconds_of(result, sky, false));
    spent_s += 1e-3 * wall.back();
    if (enough()) {
      const std::span<const std::byte> bytes = result.contents(sky.radiance);
      std::vector<float> rgba(bytes.size() / sizeof(float));
      std::memcpy(rgba.data(), bytes.data(), bytes.size());
      timing.pixels = values_at(rgba, pixels);
    }
  }
  timing.runs = static_cast<int>(wall.size());
  timing.cpu_ms = median(cpu);
  timing.device_ms = median(device);
  timing.wall_ms = median(wall);
  timing.first_ms = std::max(0.0, first_ms - timing.wall_ms);
  if (!sky.table_passes.empty()) {
    const auto known = tables.find(sky.table_keys);
    timing.tables_ms = known != tables.end() ? known->second : time_tables(executor, scene);
    tables[sky.table_keys] = timing.tables_ms;
  }
  return timing;
}

Timing time_on_host(const Scene& scene, const PixelSet& pixels) {
  Timing timing;
  const double cpu_before = process_cpu_ms();
  const Clock::time_point start = Clock::now();
  const HostPicture picture =
      find_method(scene.render.method)->render_on_host(scene, air_of(scene), View{.directions = pixels.directions}, {});
  const auto of_picture = static_cast<double>(scene.image.width) * static_cast<double>(scene.image.height);
  timing.share = static_cast<double>(pixels.places.size()) / of_picture;
  timing.wall_ms = ms_since(start);
  timing.device_ms = timing.wall_ms / timing.share;
  timing.cpu_ms = (process_cpu_ms() - cpu_before) / timing.share;
  timing.runs = 1;
  for (std::size_t i = 0; i < pixels.places.size(); ++i) {
    const float* rgb = picture.radiance.at(static_cast<int>(i), 0);
    timing.pixels.insert(timing.pixels.end(), rgb, rgb + 3);
  }
  return timing;
}

}  // namespace airlight::chart
