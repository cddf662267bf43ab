#include "core/chart/timing.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <span>

#include "core/base/clock.h"
#include "core/choice/cost.h"
#include "core/methods/ready.h"
#include "core/render/picture_key.h"
#include "core/render/sky.h"

namespace airlight::chart {
namespace {

// The passes of one picture, in as many plans as it has tiles of whole rows.
struct Sky {
  std::vector<Plan> plans;
  std::vector<BufferId> radiance;
  std::set<std::string, std::less<>> table_passes;  // passes whose output is kept for later pictures
  std::string table_keys;
};

int rows_of_tile(const Scene& scene, std::size_t most_bytes) {
  const std::size_t row = 4 * sizeof(float) * static_cast<std::size_t>(scene.image.width);
  return std::clamp(static_cast<int>(most_bytes / row), 1, scene.image.height);
}

Sky sky_of(const Stage& stage, std::size_t tile_bytes) {
  const Scene& scene = stage.scene();
  Sky sky;
  const int rows = rows_of_tile(scene, tile_bytes);
  const bool whole = rows == scene.image.height;
  const std::string own = whole ? std::string() : picture_key();  // key of what this picture's tiles share
  for (int y = 0; y < scene.image.height; y += rows) {
    const Tile tile{0, y, scene.image.width, std::min(rows, scene.image.height - y)};
    const View view = whole ? View{} : View{.directions = {}, .tile = tile, .kept_as = own};
    Plan& plan = sky.plans.emplace_back();
    sky.radiance.push_back(add_sky(plan, stage, view, false).radiance);
  }
  const Plan& first = sky.plans.front();
  const auto is_kept_longer = [&](ResourceId id) {
    return choice::is_table(first, id) && (whole || !first.images()[std::get<ImageId>(id).index].key.starts_with(own));
  };
  const std::vector<bool> runs = passes_to_run(first, is_kept_longer);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i]) {
      sky.table_passes.insert(pass_name(first.passes()[i]));
    }
  }
  for (const ImageDesc& image : first.images()) {
    sky.table_keys += whole || !image.key.starts_with(own) ? image.key : std::string();
  }
  return sky;
}

// Passes of a table that the device had at once with one of the picture count as the picture's.
bool is_of_tables(const Sky& sky, std::string_view names) {
  const std::size_t end = names.find(kAtOnce);
  return sky.table_passes.contains(names.substr(0, end)) &&
         (end == std::string_view::npos || is_of_tables(sky, names.substr(end + kAtOnce.size())));
}

double milliseconds_of(const std::vector<RunResult>& results, const Sky& sky, bool tables) {
  double sum = 0.0;
  for (const RunResult& result : results) {
    for (const PassTiming& pass : result.passes) {
      sum += is_of_tables(sky, pass.name) == tables ? pass.milliseconds : 0.0;
    }
  }
  return sum;
}

std::vector<RunResult> run(Executor& executor, const Sky& sky) {
  std::vector<RunResult> results;
  for (const Plan& plan : sky.plans) {
    results.push_back(executor.run(plan));
  }
  return results;
}

// A planet that differs by a hair: the same shaders, but tables that are not there yet.
Scene neighbour(Scene scene, int n) {
  auto radius = static_cast<float>(scene.planet.ground_radius);
  for (int i = 0; i < n; ++i) {
    radius = std::nextafter(radius, std::numeric_limits<float>::infinity());
  }
  scene.planet.ground_radius = static_cast<double>(radius);
  return scene;
}

double time_tables(Executor& executor, const Stage& stage, std::size_t tile_bytes) {
  constexpr int kBakes = 3;
  std::vector<double> bakes;
  for (int n = 1; n <= kBakes; ++n) {
    const Sky sky = sky_of(ready(neighbour(stage.scene(), n), stage), tile_bytes);
    bakes.push_back(milliseconds_of(run(executor, sky), sky, true));
  }
  return median(std::move(bakes));
}

void append(std::vector<float>& values, std::span<const std::byte> bytes) {
  const std::size_t before = values.size();
  values.resize(before + bytes.size() / sizeof(float));
  std::memcpy(values.data() + before, bytes.data(), bytes.size());
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Timing time_on_device(Executor& executor, const Stage& stage, const PixelSet& pixels, const TimingRules& rules,
                      TableTimes& tables) {
  Sky sky = sky_of(stage, rules.tile_bytes);
  const Clock::time_point begin = Clock::now();
  run(executor, sky);
  const double first_ms = milliseconds_since(begin);
  for (const Clock::time_point warm = Clock::now();
       !executor.device().is_cpu && sky.plans.size() == 1 && milliseconds_since(warm) < 1e3 * rules.warm_s;) {
    run(executor, sky);
  }

  Timing timing;
  std::vector<double> cpu;
  std::vector<double> device;
  std::vector<double> wall;
  double spent_s = 0.0;
  std::vector<float> rgba;
  const auto enough = [&] {
    const auto runs = static_cast<int>(wall.size());
    const int fewest = !wall.empty() && wall.front() > 1e3 * rules.long_s ? 1 : rules.fewest_runs;
    return runs >= rules.most_runs || (runs >= fewest && spent_s >= rules.enough_s);
  };
  while (!enough()) {
    if (sky.plans.size() > 1) {
      sky = sky_of(stage, rules.tile_bytes);  // another picture's plans
    }
    const double cpu_before = process_cpu_ms();
    const Clock::time_point start = Clock::now();
    const std::vector<RunResult> results = run(executor, sky);
    wall.push_back(milliseconds_since(start));
    cpu.push_back(process_cpu_ms() - cpu_before);
    device.push_back(milliseconds_of(results, sky, false));
    spent_s += 1e-3 * wall.back();
    if (enough() && sky.plans.size() == 1) {
      append(rgba, results.front().contents(sky.radiance.front()));
    }
  }
  if (sky.plans.size() > 1) {
    // A run's results stay until the next run: the picture is rendered once more, and each tile is read before the
    // next.
    sky = sky_of(stage, rules.tile_bytes);
    for (std::size_t i = 0; i < sky.plans.size(); ++i) {
      append(rgba, executor.run(sky.plans[i]).contents(sky.radiance[i]));
    }
  }
  timing.pixels = values_at(rgba, pixels);
  timing.runs = static_cast<int>(wall.size());
  timing.cpu_ms = median(cpu);
  timing.device_ms = median(device);
  timing.wall_ms = median(wall);
  timing.first_ms = std::max(0.0, first_ms - timing.wall_ms);
  if (!sky.table_passes.empty()) {
    const auto known = tables.find(sky.table_keys);
    timing.tables_ms = known != tables.end() ? known->second : time_tables(executor, stage, rules.tile_bytes);
    tables[sky.table_keys] = timing.tables_ms;
  }
  return timing;
}

Timing time_on_host(const Stage& stage, const PixelSet& pixels) {
  const Scene& scene = stage.scene();
  Timing timing;
  const double cpu_before = process_cpu_ms();
  const Clock::time_point start = Clock::now();
  const HostPicture picture = stage.method().render_on_host(stage, View{.directions = pixels.directions}, {});
  const auto of_picture = static_cast<double>(scene.image.width) * static_cast<double>(scene.image.height);
  timing.share = static_cast<double>(pixels.places.size()) / of_picture;
  timing.wall_ms = milliseconds_since(start);
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
