#include "core/methods/ground_pass.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/air/scene_block.h"
#include "core/plan/bytes.h"
#include "core/things/ground.h"

namespace airlight {
namespace {

constexpr std::uint32_t kViewColumns = 256;
constexpr std::uint32_t kMomentIrradianceColumns = 1024;

device::GroundData narrowed_ground(const physics::GroundData& g) {
  device::GroundData out{};
  out.shape.pole = narrowed(g.shape.pole);
  out.shape.greenwich = narrowed(g.shape.greenwich);
  out.shape.east = narrowed(g.shape.east);
  out.shape.albedo_rows = g.shape.albedo_rows;
  out.shape.albedo_levels = g.shape.albedo_levels;
  out.shape.water_rows = g.shape.water_rows;
  out.shape.water_levels = g.shape.water_levels;
  out.shape.slope_variance = narrowed(g.shape.slope_variance);
  std::ranges::copy(g.albedo_first, std::begin(out.albedo_first));
  std::ranges::copy(g.water_first, std::begin(out.water_first));
  std::ranges::transform(g.glint_share, std::begin(out.glint_share), [](double x) { return narrowed(x); });
  return out;
}

std::vector<Binding> add_ground_buffers(Plan& plan, const Part& part) {
  const auto ground = part.things.ground();
  const auto add = [&](const char* name, std::vector<std::byte> contents, const std::string& buffer_key) {
    return Binding{name, plan.add_buffer(filled_buffer(name, std::move(contents), buffer_key))};
  };
  const std::string key = ground_key(part.scene);
  return {add("ground_head", bytes_of_one(narrowed_ground(ground->head)), {}),
          add("ground_albedo", bytes_of(*ground->albedo), key + " albedo"),
          add("ground_water", bytes_of(*ground->water), key + " water")};
}

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
    plan.begin_scene(device_scene_bytes(black, tile_of(part.scene, view)), " over a black ground", {});
  }
}

void end_black_ground(Plan& plan, const Part& part) {
  if (part.scene.ground) {
    plan.end_scene();
  }
}

void add_ground_map(Plan& plan, const Part& part, const SkyTarget& target, GroundLight light) {
  if (!part.scene.ground) {
    return;
  }
  std::vector<Binding> reads = add_ground_buffers(plan, part);
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
                 .push_constants = {target.grid.width, target.grid.height},
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

std::string ground_layers_refusal(const Scene& scene) {
  if (!scene.ground) {
    return {};
  }
  const char* key = scene.ground->albedo_map.empty() ? "planet.ocean" : "planet.albedo_map";
  return std::string(key) + ": its light is not kept apart by layers; remove one of the two";
}

}  // namespace airlight
