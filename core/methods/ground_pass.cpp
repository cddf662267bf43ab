#include "core/methods/ground_pass.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/air/scene_block.h"
#include "core/ground/ground.h"
#include "core/methods/scene_air.h"

namespace airlight {
namespace {

constexpr std::uint32_t kViewColumns = 256;
constexpr std::uint32_t kMomentIrradianceColumns = 1024;

float in_float(double x) {
  return static_cast<float>(x);
}

device::vec3 in_float(const physics::vec3& v) {
  return {in_float(v.x), in_float(v.y), in_float(v.z)};
}

device::GroundData in_float(const physics::GroundData& g) {
  device::GroundData out{};
  out.shape.pole = in_float(g.shape.pole);
  out.shape.greenwich = in_float(g.shape.greenwich);
  out.shape.east = in_float(g.shape.east);
  out.shape.albedo_rows = g.shape.albedo_rows;
  out.shape.albedo_levels = g.shape.albedo_levels;
  out.shape.water_rows = g.shape.water_rows;
  out.shape.water_levels = g.shape.water_levels;
  out.shape.slope_variance = in_float(g.shape.slope_variance);
  std::copy(std::begin(g.albedo_first), std::end(g.albedo_first), std::begin(out.albedo_first));
  std::copy(std::begin(g.water_first), std::end(g.water_first), std::begin(out.water_first));
  std::transform(std::begin(g.glint_share), std::end(g.glint_share), std::begin(out.glint_share),
                 [](double x) { return in_float(x); });
  return out;
}

BufferId add_texels(Plan& plan, const char* name, const std::vector<physics::uint>& texels, const std::string& key) {
  std::vector<std::byte> bytes(texels.size() * sizeof(physics::uint));
  std::memcpy(bytes.data(), texels.data(), bytes.size());
  const std::size_t size = bytes.size();
  return plan.add_buffer({.name = name, .bytes = size, .contents = std::move(bytes), .key = key});
}

std::vector<Binding> add_ground_buffers(Plan& plan, const Scene& scene) {
  const auto ground = ground_of(scene);
  const device::GroundData head = in_float(ground->head);
  std::vector<std::byte> bytes(sizeof head);
  std::memcpy(bytes.data(), &head, sizeof head);
  const std::string key = ground_key(scene);
  return {{"ground_head", plan.add_buffer({.name = "ground_head", .bytes = sizeof head, .contents = std::move(bytes)})},
          {"ground_albedo", add_texels(plan, "ground_albedo", *ground->albedo, key + " albedo")},
          {"ground_water", add_texels(plan, "ground_water", *ground->water, key + " water")}};
}

// Those of the constants that a shader's own list may hold.
std::vector<Specialization> without(std::vector<Specialization> constants, std::string_view prefix) {
  std::erase_if(constants, [&](const Specialization& c) { return c.name.starts_with(prefix); });
  return constants;
}

ImageId add_ground_view(Plan& plan, std::vector<Specialization> constants) {
  const ImageId view = plan.add_image({.name = "ground_view", .extent = {kViewColumns, 1, 1}});
  plan.add_pass({.name = "ground_view",
                 .shader = "ground_view",
                 .reads = {},
                 .writes = {{"ground_view_out", view}},
                 .grid = {kViewColumns, 1, 1},
                 .specialization = std::move(constants),
                 .cost = 200.0});
  return view;
}

}  // namespace

void begin_black_ground(Plan& plan, const Scene& scene, const View& view) {
  if (scene.ground) {
    Scene black = scene;
    black.planet.ground_albedo = {};
    plan.begin_scene(device_scene_bytes(air_of(black), black, tile_of(scene, view)), " over a black ground", {});
  }
}

void end_black_ground(Plan& plan, const Scene& scene) {
  if (scene.ground) {
    plan.end_scene();
  }
}

void add_ground_map(Plan& plan, const Scene& scene, const SkyTarget& target, GroundLight light) {
  if (!scene.ground) {
    return;
  }
  std::vector<Binding> reads = add_ground_buffers(plan, scene);
  reads.push_back({"ground_view", add_ground_view(plan, without(light.constants, "kTransmittance"))});
  reads.push_back({"transmittance_lut", light.transmittance});
  reads.push_back({"ground_irradiance_lut", light.irradiance});
  reads.push_back({"directions", target.directions});
  std::vector<Specialization> constants =
      without(without(without(std::move(light.constants), "kMoment"), "kDelta"), "kShell");
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
