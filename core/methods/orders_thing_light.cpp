// What things do to the light that the table of moments holds: terrain by shares in a grid around it
// (shaders/physics/thing_light.glsl), bodies by the caps of the sky that they hide (shaders/physics/sky_caps.glsl).

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/luts/luts.h"
#include "core/methods/orders_parts.h"
#include "core/things/ground.h"
#include "core/things/terrain.h"
#include "core/things/thing_buffers.h"

namespace airlight::orders {
namespace {

constexpr std::uint32_t kRounds = 3;  // of light sent to and fro
constexpr double kCells = 1000.0;     // of the grid of air, each with all layers
constexpr double kSlopeCells = 4000.0;

struct LightGrid {
  std::uint32_t columns;
  std::uint32_t rows;
};

LightGrid grid_of(const physics::TerrainData& t, double cells) {
  const double ratio = std::sqrt((t.columns - 1.0) / (t.rows - 1.0));
  const auto side = [&](double share) {
    return static_cast<std::uint32_t>(std::clamp(std::lround(std::sqrt(cells) * share), 8L, 512L));
  };
  return {side(ratio), side(1.0 / ratio)};
}

// All that the shares depend on beside the grid: where the camera stands and looks, because the air next to it is taken
// as it is seen.
std::string light_key(const Plan& plan, const Part& part, const char* table, const LightGrid& grid,
                      const Light& light) {
  const Scene& scene = part.scene;
  std::string key = std::string(table) + " " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                    " among " + terrain_key(*scene.terrain) + " " + shadow_key(scene) +
                    (scene.ground ? " on " + ground_key(scene) : std::string()) + " from";
  for (const double number : {scene.camera.altitude, scene.camera.azimuth, scene.camera.pitch}) {
    key += " " + shortest(number);
  }
  return key + " by " + std::to_string(light.steps) + " steps, " + plan.images()[light.moments.index].key;
}

struct Maker {
  Plan& plan;
  const Part& part;
  std::vector<Binding> reads;
  std::vector<Specialization> constants;
  ImageId open;

  // `before`: the shares of the round before; in the first round they are not read. `key`: empty for a table that only
  // others are made from.
  ImageId add(const std::string& name, const LightGrid& grid, ImageId before, std::uint32_t first_layer,
              bool first_round, const std::string& key = {}) {
    const std::uint32_t rows = grid.rows * (physics::kLightLayers + 1 - first_layer);
    const ImageId out =
        plan.add_image({.name = name, .extent = {2 * grid.columns, rows, 1}, .key = key, .stored = !key.empty()});
    std::vector<Binding> all = reads;
    all.push_back({"open_lut", open});
    all.push_back({"shares_lut", before});
    plan.add_pass({.name = name,
                   .shader = "thing_light",
                   .reads = std::move(all),
                   .writes = {{"shares_out", out}},
                   .grid = {physics::kLightDirections, grid.columns, rows},
                   .push_constants = {grid.columns, grid.rows, first_layer, first_round ? 1U : 0U},
                   .specialization = constants,
                   .cost = 60.0});
    return out;
  }
};

ImageId add_open_light(Plan& plan, const Light& light, const ThingInputs& things) {
  const ImageId open = plan.add_image(
      {.name = "thing_open", .extent = {3 * physics::kLightDirections, physics::kOpenRows, physics::kOpenSlices + 2}});
  std::vector<Binding> reads = light.reads();
  reads.insert(reads.end(), things.reads.begin(), things.reads.end());
  std::vector<Specialization> constants = light.constants;
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  plan.add_pass({.name = "thing_open",
                 .shader = "thing_open",
                 .reads = std::move(reads),
                 .writes = {{"open_out", open}},
                 .grid = {physics::kLightDirections, physics::kOpenRows, 1},
                 .push_constants = {light.steps},
                 .specialization = std::move(constants),
                 .cost = 4.0 * ray_cost(light.steps)});
  return open;
}

}  // namespace

ThingLight add_thing_light(Plan& plan, const Part& part, const Light& light, const ThingInputs& things) {
  if (!part.scene.terrain) {
    return {light.moments, light.moments};
  }
  const physics::TerrainData& shape = part.things.terrain()->shape;
  const LightGrid air = grid_of(shape, kCells);
  const LightGrid slopes = grid_of(shape, kSlopeCells);
  Maker maker{plan, part, light.reads(), light.constants, add_open_light(plan, light, things)};
  maker.reads.insert(maker.reads.end(), things.reads.begin(), things.reads.end());
  maker.constants.insert(maker.constants.end(), things.constants.begin(), things.constants.end());
  ImageId shares = light.moments;
  for (std::uint32_t round = 1; round <= kRounds; ++round) {
    const bool last = round == kRounds;
    shares = maker.add("thing_light_" + std::to_string(round), air, shares, 0, round == 1,
                       last ? light_key(plan, part, "thing_light", air, light) : std::string());
  }
  return {shares, maker.add("thing_light_slopes", slopes, shares, physics::kLightLayers, false,
                            light_key(plan, part, "thing_light_slopes", slopes, light))};
}

ImageId add_sky_caps(Plan& plan, const Part& part, const Light& light, const ThingInputs& things) {
  if (part.scene.spheres.empty()) {
    return light.moments;
  }
  const ImageId caps = plan.add_image({.name = "sky_caps",
                                       .extent = {physics::kCapAngles * physics::kCapSizes, 2 * physics::kCapTurns, 1},
                                       .half = true});
  const std::uint32_t steps = (light.steps + 3) / 4;
  std::vector<Binding> reads = light.reads();
  reads.insert(reads.end(), things.reads.begin(), things.reads.end());
  std::vector<Specialization> constants = light.constants;
  constants.insert(constants.end(), things.constants.begin(), things.constants.end());
  plan.add_pass({.name = "sky_caps",
                 .shader = "sky_caps",
                 .reads = std::move(reads),
                 .writes = {{"caps_out", caps}},
                 .grid = {1, 1, 1},
                 .push_constants = {steps},
                 .specialization = std::move(constants),
                 .cost = 20.0 * ray_cost(steps)});
  return caps;
}

}  // namespace airlight::orders
