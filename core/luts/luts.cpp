#include "core/luts/luts.h"

#include <cstring>
#include <string>
#include <string_view>
#include <variant>

#include "core/physics/scene_data.h"

namespace airlight {
namespace {

Extent extent_of(TableSize size) {
  return {static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), 1};
}

bool fades(const Scene& scene) {
  const auto fade = scene.render.parameters.find("sun_fade");
  return fade != scene.render.parameters.end() && std::holds_alternative<SunFade>(fade->second);
}

Extent extent_in(const Plan& plan, ImageId image) {
  return plan.images()[image.index].extent;
}

}  // namespace

// The scene block with sun direction, sun irradiance, disc and camera blanked, the media's kinds, the lesson's fade,
// the table's own name and size, and the sizes of the tables that it is made from.
std::string table_key(const Scene& scene, std::string_view table, TableSize size, std::span<const Extent> sources) {
  device::SceneData data = device_scene(scene);
  data.camera = {};
  data.sun.direction = {};
  data.sun.irradiance = {};
  data.sun.disc_radiance = {};
  data.sun.angular_radius = 0.0f;
  data.sun.limb_darkening = 0.0f;
  std::string key(table);
  for (const std::uint32_t word :
       {static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), density_profile_codes(scene),
        phase_function_codes(scene), static_cast<std::uint32_t>(scene.media.size()), fades(scene) ? 1u : 0u}) {
    key += ' ' + std::to_string(word);
  }
  for (const Extent& source : sources) {
    key += " from " + std::to_string(source.width) + 'x' + std::to_string(source.height);
  }
  key += ' ';
  key.append(reinterpret_cast<const char*>(&data), sizeof data);
  return key;
}

bool ground_reflects(const Scene& scene) {
  const Spectrum& albedo = scene.planet.ground_albedo;
  return albedo[0] > 0.0 || albedo[1] > 0.0 || albedo[2] > 0.0;
}

std::vector<Specialization> medium_specialization(const Scene& scene) {
  return {{"kMediumCount", static_cast<std::uint32_t>(scene.media.size())},
          {"kDensityProfiles", density_profile_codes(scene)},
          {"kPhaseFunctions", phase_function_codes(scene)}};
}

std::vector<Specialization> sunlight_specialization(const Plan& plan, const Scene& scene, ImageId transmittance) {
  std::vector<Specialization> constants = medium_specialization(scene);
  constants.push_back({"kSunFade", fades(scene) ? 1u : 0u});
  const Extent extent = extent_in(plan, transmittance);
  constants.push_back({"kTransmittanceWidth", extent.width});
  constants.push_back({"kTransmittanceHeight", extent.height});
  return constants;
}

void add_scattering_size(std::vector<Specialization>& constants, const Plan& plan, ImageId multiple_scattering) {
  const Extent extent = extent_in(plan, multiple_scattering);
  constants.push_back({"kScatteringWidth", extent.width});
  constants.push_back({"kScatteringHeight", extent.height});
}

ImageId add_transmittance(Plan& plan, const Scene& scene, TableSize size) {
  const ImageId out = plan.add_image({.name = "transmittance",
                                      .extent = extent_of(size),
                                      .format = Format::rgba32f,
                                      .key = table_key(scene, "transmittance", size)});
  plan.add_pass({.name = "transmittance",
                 .shader = "transmittance",
                 .reads = {},
                 .writes = {{"transmittance_out", out}},
                 .grid = extent_of(size),
                 .push_constants = {},
                 .specialization = medium_specialization(scene)});
  return out;
}

ImageId add_multiple_scattering(Plan& plan, const Scene& scene, ImageId transmittance, TableSize size) {
  const Extent sources[] = {extent_in(plan, transmittance)};
  const ImageId out = plan.add_image({.name = "multiple_scattering",
                                      .extent = extent_of(size),
                                      .format = Format::rgba32f,
                                      .key = table_key(scene, "multiple_scattering", size, sources)});
  plan.add_pass({.name = "multiple_scattering",
                 .shader = "multiple_scattering",
                 .reads = {{"transmittance_lut", transmittance}},
                 .writes = {{"multiple_scattering_out", out}},
                 .grid = {physics::kMultipleScatteringDirections, static_cast<std::uint32_t>(size[0]),
                          static_cast<std::uint32_t>(size[1])},
                 .push_constants = {},
                 .specialization = sunlight_specialization(plan, scene, transmittance)});
  return out;
}

ImageId add_ground_irradiance(Plan& plan, const Scene& scene, ImageId transmittance, ImageId multiple_scattering) {
  const TableSize size{static_cast<int>(physics::kGroundIrradianceSize), 1};
  const Extent sources[] = {extent_in(plan, transmittance), extent_in(plan, multiple_scattering)};
  const ImageId out = plan.add_image({.name = "ground_irradiance",
                                      .extent = extent_of(size),
                                      .format = Format::rgba32f,
                                      .key = table_key(scene, "ground_irradiance", size, sources)});
  std::vector<Specialization> constants = sunlight_specialization(plan, scene, transmittance);
  add_scattering_size(constants, plan, multiple_scattering);
  plan.add_pass({.name = "ground_irradiance",
                 .shader = "ground_irradiance",
                 .reads = {{"transmittance_lut", transmittance}, {"multiple_scattering_lut", multiple_scattering}},
                 .writes = {{"ground_irradiance_out", out}},
                 .grid = {physics::kGroundIrradianceDirections, physics::kGroundIrradianceSize, 1},
                 .push_constants = {},
                 .specialization = constants});
  return out;
}

}  // namespace airlight
