#include "core/luts/luts.h"

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>

namespace airlight {
namespace {

Extent extent_of(TableSize size) {
  return {static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), 1};
}

Extent extent_in(const Plan& plan, ImageId image) {
  return plan.images()[image.index].extent;
}

// The inverse of transmittance_coordinate(): x stands for the path to the top, y for the distance to the horizon.
TableText transmittance_text(const Air& air) {
  const Planet planet = optical_planet(air);
  return {.quantity = "transmittance to the top of the atmosphere",
          .unit = "1",
          .axes = {{"x", "mu", "1",
                    "zenith cosine of the ray, linear in the distance to the top, from the zenith to the horizon"},
                   {"y", "altitude_km", "km",
                    "linear in the distance to the ground's horizon, from the ground to the top of the atmosphere"}},
          .constants = planet_constants(planet),
          .decode = R"(x = i / (width - 1)
y = j / (height - 1)
farthest_horizon_km = sqrt(top_km * (2 * ground_radius_km + top_km))
horizon_km = y * farthest_horizon_km
altitude_km = horizon_km * horizon_km / (ground_radius_km + sqrt(ground_radius_km * ground_radius_km + horizon_km * horizon_km))
nearest_km = top_km - altitude_km
path_km = nearest_km + x * (horizon_km + farthest_horizon_km - nearest_km)
squares = (farthest_horizon_km - horizon_km) * (farthest_horizon_km + horizon_km) - path_km * path_km
mu = where(path_km < 1e-9, 1, clip(squares / (2 * (ground_radius_km + altitude_km) * maximum(path_km, 1e-9)), -1, 1))
)"};
}

// The inverse of scattering_coordinate().
TableText multiple_scattering_text(const Planet& planet) {
  return {.quantity =
              "radiance of light scattered or reflected at least once, the mean over all directions, for a sun "
              "of irradiance 1",
          .unit = "1/sr",
          .axes = {{"x", "mu_sun", "1", "zenith cosine of the sun, s abs(s) with s linear from -1 to 1"},
                   {"y", "altitude_km", "km", "linear, from the ground to the top of the atmosphere"}},
          .constants = planet_constants(planet),
          .decode = R"(s = 2 * i / (width - 1) - 1
mu_sun = s * abs(s)
altitude_km = top_km * j / (height - 1)
)"};
}

// Two tables, one below the other. The decoded angles are those of the table's rows.
TableText bent_sunlight_text(const Air& air) {
  TableText text = transmittance_text(air);
  text.quantity =
      "sunlight through air that bends it, with the beam's spreading; in the lower half transmittance along "
      "directions as they are seen; altitudes are optical";
  text.axes[0].mapping = "zenith cosine, in the upper half that at which a sun that rises stands at the horizon";
  text.axes[1].mapping = "in each half linear in the distance to the ground's horizon, from the ground to the top";
  return in_lower_half_too(std::move(text));
}

TableText ground_irradiance_text() {
  return {.quantity = "irradiance of the sky on level ground for a sun of irradiance 1",
          .unit = "1",
          .axes = {{"x", "mu_sun", "1", "zenith cosine of the sun, linear from -1 to 1"}},
          .constants = {},
          .decode = "mu_sun = 2 * i / (width - 1) - 1\n"};
}

}  // namespace

Planet optical_planet(const Air& air) {
  Planet planet = air.planet();
  planet.ground_radius = air.formulas().scene.planet.ground_radius;
  planet.atmosphere_height = air.formulas().scene.planet.atmosphere_height;
  return planet;
}

TableText in_lower_half_too(TableText text) {
  text.decode = "height = height / 2\nj = j - height * (j >= height)\n" + text.decode;
  return text;
}

std::string planet_constants(const Planet& planet) {
  return table_constant("ground_radius_km", planet.ground_radius) + table_constant("top_km", planet.atmosphere_height);
}

std::string table_key(const Air& air, std::string_view table, TableSize size, std::span<const Extent> sources) {
  std::string key(table);
  key += ' ' + std::to_string(size[0]) + ' ' + std::to_string(size[1]);
  for (const Extent& source : sources) {
    key += " from " + std::to_string(source.width) + 'x' + std::to_string(source.height);
  }
  return key + ' ' + air.key();
}

std::vector<Specialization> medium_specialization(const Air& air) {
  const physics::Physics& p = air.formulas();
  physics::uint most = 0;
  for (physics::uint i = 0; i < p.media; ++i) {
    most = std::max(most, p.scene.media[i].layer_count);
  }
  // By powers of two, so that lists of about one length share their pipelines.
  return {{"kMediumCount", p.media},
          {"kDensityProfiles", p.density_profiles},
          {"kPhaseFunctions", p.phase_functions},
          {"kSunFade", p.fade ? 1U : 0U},
          {"kRefraction", p.refraction ? 1U : 0U},
          {"kMostLayers", most == 0 ? 0 : std::bit_ceil(most)}};
}

std::vector<Specialization> sunlight_specialization(const Plan& plan, const Air& air, ImageId transmittance) {
  std::vector<Specialization> constants = medium_specialization(air);
  const Extent extent = extent_in(plan, transmittance);
  constants.push_back({"kTransmittanceWidth", extent.width});
  constants.push_back({"kTransmittanceHeight", air.formulas().refraction ? extent.height / 2 : extent.height});
  return constants;
}

void add_scattering_size(std::vector<Specialization>& constants, const Plan& plan, ImageId multiple_scattering) {
  const Extent extent = extent_in(plan, multiple_scattering);
  constants.push_back({"kScatteringWidth", extent.width});
  constants.push_back({"kScatteringHeight", extent.height});
}

namespace {

// Transmittance along directions as they are seen, and bending.
ImageId add_seen_transmittance(Plan& plan, const Air& air, TableSize size, const std::string& name) {
  if (const auto there = plan.table_of(table_key(air, name, size))) {
    return *there;
  }
  const ImageId out = plan.add_image(
      {.name = name, .extent = extent_of(size), .key = table_key(air, name, size), .stored = true, .text = [air] {
         return transmittance_text(air);
       }});
  plan.add_pass({.name = name,
                 .shader = "transmittance",
                 .writes = {{"transmittance_out", out}},
                 .grid = extent_of(size),
                 .specialization = medium_specialization(air),
                 .cost = 12.0});
  return out;
}

}  // namespace

ImageId add_bent_sunlight(Plan& plan, const Air& air, TableSize size, const BentTable& table,
                          std::vector<Specialization> constants) {
  const TableSize both{size[0], 2 * size[1]};
  if (const auto there = plan.table_of(table_key(air, table.name, both))) {
    return *there;
  }
  const ImageId seen = add_seen_transmittance(plan, air, size, table.name + "_seen");
  const ImageId out = plan.add_image({.name = table.name,
                                      .extent = extent_of(both),
                                      .key = table_key(air, table.name, both),
                                      .stored = true,
                                      .text = table.text});
  plan.add_pass({.name = table.name,
                 .shader = table.shader,
                 .reads = {{"seen_lut", seen}},
                 .writes = {{table.out, out}},
                 .grid = extent_of(size),
                 .specialization = std::move(constants),
                 .cost = 16.0});
  return out;
}

ImageId add_transmittance(Plan& plan, const Air& air, TableSize size) {
  if (!air.formulas().refraction) {
    return add_seen_transmittance(plan, air, size, "transmittance");
  }
  return add_bent_sunlight(
      plan, air, size, {"transmittance", "bent_sunlight", "sunlight_out", [air] { return bent_sunlight_text(air); }},
      medium_specialization(air));
}

ImageId add_multiple_scattering(Plan& plan, const Air& air, ImageId transmittance, TableSize size) {
  const Extent sources[] = {extent_in(plan, transmittance)};
  if (const auto there = plan.table_of(table_key(air, "multiple_scattering", size, sources))) {
    return *there;
  }
  const ImageId out =
      plan.add_image({.name = "multiple_scattering",
                      .extent = extent_of(size),
                      .key = table_key(air, "multiple_scattering", size, sources),
                      .stored = true,
                      .text = [planet = optical_planet(air)] { return multiple_scattering_text(planet); }});
  plan.add_pass({.name = "multiple_scattering",
                 .shader = "multiple_scattering",
                 .reads = {{"transmittance_lut", transmittance}},
                 .writes = {{"multiple_scattering_out", out}},
                 .grid = {physics::kMultipleScatteringDirections, static_cast<std::uint32_t>(size[0]),
                          static_cast<std::uint32_t>(size[1])},
                 .specialization = sunlight_specialization(plan, air, transmittance),
                 .cost = 44.0});
  return out;
}

ImageId add_ground_irradiance(Plan& plan, const Air& air, ImageId transmittance, ImageId multiple_scattering) {
  const TableSize size{static_cast<int>(physics::kGroundIrradianceSize), 1};
  const Extent sources[] = {extent_in(plan, transmittance), extent_in(plan, multiple_scattering)};
  if (const auto there = plan.table_of(table_key(air, "ground_irradiance", size, sources))) {
    return *there;
  }
  const ImageId out = plan.add_image({.name = "ground_irradiance",
                                      .extent = extent_of(size),
                                      .key = table_key(air, "ground_irradiance", size, sources),
                                      .stored = true,
                                      .text = ground_irradiance_text});
  std::vector<Specialization> constants = sunlight_specialization(plan, air, transmittance);
  add_scattering_size(constants, plan, multiple_scattering);
  plan.add_pass({.name = "ground_irradiance",
                 .shader = "ground_irradiance",
                 .reads = {{"transmittance_lut", transmittance}, {"multiple_scattering_lut", multiple_scattering}},
                 .writes = {{"ground_irradiance_out", out}},
                 .grid = {physics::kGroundIrradianceDirections, physics::kGroundIrradianceSize, 1},
                 .specialization = constants,
                 .cost = 44.0});
  return out;
}

}  // namespace airlight
