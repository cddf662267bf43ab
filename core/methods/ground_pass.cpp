#include "core/methods/ground_pass.h"

#include <algorithm>
#include <utility>

#include "core/air/scene_block.h"
#include "core/methods/spectral_sums.h"
#include "core/things/thing_buffers.h"

namespace airlight {
namespace {

constexpr std::uint32_t kViewColumns = 256;
constexpr std::uint32_t kMomentIrradianceColumns = 1024;

// The constants without those of this prefix, which belong to other shaders.
std::vector<Specialization> without(std::vector<Specialization> constants, std::string_view prefix) {
  std::erase_if(constants, [&](const Specialization& c) { return c.name.starts_with(prefix); });
  return constants;
}

ImageId add_ground_view(Plan& plan, std::vector<Specialization> constants) {
  const ImageId view = plan.add_image({.name = "ground_view", .extent = {kViewColumns, 1, 1}});
  plan.add_pass({.name = "ground_view",
                 .shader = "ground_view",
                 .writes = {{"ground_view_out", view}},
                 .grid = {kViewColumns, 1, 1},
                 .specialization = std::move(constants),
                 .cost = 200.0});
  return view;
}

}  // namespace

void begin_black_ground(Plan& plan, const Part& part, const View& view) {
  if (part.scene.ground) {
    physics::Physics black = formulas_of(part.air, part.scene);
    black.scene.planet.ground_albedo = {};
    plan.begin_scene(device_scene_bytes(black, tile_of(part.scene, view)), part.suffix + " over a black ground",
                     part.channels);
  }
}

void end_black_ground(Plan& plan, const Part& part, const View& view) {
  if (part.scene.ground) {
    plan.end_scene();
    begin_part(plan, part, tile_of(part.scene, view));
  }
}

void add_ground_map(Plan& plan, const Part& part, const SkyTarget& target, GroundLight light) {
  if (!part.scene.ground) {
    return;
  }
  std::vector<Binding> reads = add_ground_maps(plan, part.scene, part.things);
  reads.push_back({"ground_view", add_ground_view(plan, without(light.constants, "kTransmittance"))});
  reads.push_back({"transmittance_lut", light.transmittance});
  reads.push_back({"ground_irradiance_lut", light.irradiance});
  reads.push_back({"directions", target.directions});
  std::vector<Specialization> constants =
      without(without(without(without(std::move(light.constants), "kMoment"), "kSource"), "kDelta"), "kShell");
  constants.push_back({"kEdges", physics::kEdgesFound});
  constants.push_back({"kProjection", target.projection});
  const std::uint32_t columns = plan.images()[light.irradiance.index].extent.width;
  constants.push_back({"kIrradianceColumns", light.sky ? columns : 0U});
  constants.push_back({"kViewColumns", kViewColumns});
  plan.add_pass({.name = "ground",
                 .shader = "ground_map",
                 .reads = std::move(reads),
                 .writes = {{"radiance_out", target.radiance}},
                 .grid = target.grid,
                 .push_constants = {target.grid.width, target.grid.height, target.vectors},
                 .specialization = std::move(constants),
                 .cost = 10.0});
}

ImageId add_moment_irradiance(Plan& plan, ImageId moments, std::vector<Specialization> constants) {
  const ImageId out = plan.add_image({.name = "moment_irradiance", .extent = {kMomentIrradianceColumns, 1, 1}});
  plan.add_pass({.name = "moment_irradiance",
                 .shader = "moment_irradiance",
                 .reads = {{"moments_lut", moments}},
                 .writes = {{"ground_irradiance_out", out}},
                 .grid = {kMomentIrradianceColumns, 1, 1},
                 .specialization = std::move(constants),
                 .cost = 1.0});
  return out;
}

}  // namespace airlight
