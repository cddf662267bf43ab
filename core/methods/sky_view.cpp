// `sky-view`: a march for each texel of a small table of what the camera sees, then one fetch a pixel [H20 sec. 5.3].
// Views from above the air march pixel by pixel.

#include <array>

#include "core/methods/ground_pass.h"
#include "core/methods/march_passes.h"
#include "core/methods/methods.h"
#include "core/scene/angle.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

constexpr std::array<std::string_view, 2> kGroundRays{"table", "march"};

// The table holds the ground too. Compared with marching those pixels, this costs 0.03 % in the mean (worst scene
// tried) and saves nine tenths of the time of a picture one third ground.
const std::array<ParameterInfo, 9> kParameters{
    parameter::table_size("sky_view_lut", 4, 4096, TableSize{192, 108},
                          "sky-view table, azimuths from the sun x angles from the horizon"),
    parameter::choice(
        "ground_rays", kGroundRays, "table",
        "rays that end on the ground: from the last third of the table's rows, or marched pixel by pixel"),
    steps_parameter(32),
    step_distribution_parameter(),
    phase_parameter(),
    transmittance_lut_parameter(),
    multiple_scattering_lut_parameter(),
    multiple_scattering_scale_parameter(),
    sun_fade_parameter()};

bool ground_marches(const Scene& scene) {
  return scene.render.get<std::string>("ground_rays") == "march";
}

// Rows above the horizon.
std::uint32_t sky_rows(const Scene& scene) {
  const auto rows = static_cast<std::uint32_t>(scene.render.get<TableSize>("sky_view_lut")[1]);
  return ground_marches(scene) ? rows : 2 * rows / 3;
}

std::vector<Binding> reads_of(const MarchTables& tables) {
  std::vector<Binding> reads = march_reads(tables);
  reads.push_back({"ground_irradiance_lut", tables.ground_irradiance});
  return reads;
}

std::vector<Specialization> constants_of(const Plan& plan, const Part& part, const MarchTables& tables) {
  std::vector<Specialization> constants = march_specialization(plan, part, tables);
  constants.push_back({"kGroundReflects", tables.reflects ? 1u : 0u});
  return constants;
}

// The text for the map of sky_view_ray().
TableText sky_view_text(double ground_radius, double altitude, std::uint32_t rows_above) {
  return {.quantity = "radiance seen from the camera, for a sun of the preset's irradiance",
          .unit = "unit of sun.irradiance / sr",
          .axes = {{"x", "azimuth_rad", "rad",
                    "azimuth from the sun's, linear in the sine of its half; 0 is between texels"},
                   {"y", "elevation_rad", "rad",
                    "quadratic from the true horizon up to the zenith, then from the horizon down to the nadir"}},
          .constants = table_constant("ground_radius_km", ground_radius) + table_constant("camera_km", altitude) +
                       table_constant("sky_rows", rows_above),
          .decode = R"(sine = (i + 0.5) / (width - 0.5)
azimuth_rad = 2 * arctan2(sine, sqrt(maximum(1 - sine * sine, 0)))
dip = arctan2(sqrt(camera_km * (2 * ground_radius_km + camera_km)), ground_radius_km)
up = j / (sky_rows - 1)
down = (j - sky_rows) / maximum(height - sky_rows - 1, 1)
elevation_rad = where(j < sky_rows, up * up * (pi / 2 + dip) - dip, -dip - down * down * (pi / 2 - dip))
)"};
}

// The table also depends on the sun's elevation and the camera's altitude, and is made anew for each picture.
ImageId add_sky_view_table(Plan& plan, const Part& part, const View& view, const MarchTables& tables) {
  const TableSize size = part.scene.render.get<TableSize>("sky_view_lut");
  const Extent extent{static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), 1};
  const ImageId out =
      plan.add_image({.name = "sky_view",
                      .extent = extent,
                      .key = picture_table_key(view, "sky_view"),
                      .text = [radius = part.scene.planet.ground_radius, altitude = part.scene.camera.altitude,
                               rows = sky_rows(part.scene)] { return sky_view_text(radius, altitude, rows); }});
  plan.add_pass(
      {.name = "sky_view",
       .shader = "sky_view",
       .reads = reads_of(tables),
       .writes = {{"sky_view_out", out}},
       .grid = extent,
       .push_constants = {static_cast<std::uint32_t>(part.scene.render.get<int>("steps")), sky_rows(part.scene)},
       .specialization = constants_of(plan, part, tables),
       .cost = march_cost(part.scene.render.get<int>("steps"))});
  return out;
}

// The constants of a pass that reads such a table, or one with blocks of its size.
std::vector<Specialization> fetch_constants(const Plan& plan, const Part& part, const MarchTables& tables) {
  const TableSize size = part.scene.render.get<TableSize>("sky_view_lut");
  std::vector<Specialization> constants = constants_of(plan, part, tables);
  constants.push_back({"kSkyViewWidth", static_cast<std::uint32_t>(size[0])});
  constants.push_back({"kSkyViewHeight", static_cast<std::uint32_t>(size[1])});
  constants.push_back({"kSkyViewSkyRows", sky_rows(part.scene)});
  constants.push_back({"kGroundMarches", ground_marches(part.scene) ? 1u : 0u});
  return constants;
}

void add_fetch_pass(Plan& plan, const Part& part, const View& view, const MarchTables& tables, ImageId sky_view,
                    const SkyTarget& target) {
  std::vector<Specialization> constants = fetch_constants(plan, part, tables);
  constants.push_back({"kProjection", target.projection});
  std::vector<Binding> reads = reads_of(tables);
  reads.push_back({"sky_view_lut", sky_view});
  reads.push_back({"directions", target.directions});
  add_pass_with_edges(plan, part, view, target,
                      {.name = "sky",
                       .shader = "sky_from_view",
                       .reads = std::move(reads),
                       .writes = {{"radiance_out", target.radiance}},
                       .grid = target.grid,
                       .push_constants = {target.grid.width, target.grid.height,
                                          static_cast<std::uint32_t>(part.scene.render.get<int>("steps"))},
                       .specialization = std::move(constants),
                       .cost = 5.0});
}

SkyPasses add_sky_view(Plan& plan, const Part& part, const View& view) {
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  const MarchTables tables = add_march_tables(plan, part);
  std::vector<ImageId> list = tables.list();
  begin_black_ground(plan, part, view);
  if (part.scene.camera.altitude >= part.scene.planet.atmosphere_height) {
    add_march_pass(plan, part, tables, target);
  } else {
    const ImageId sky_view = add_sky_view_table(plan, part, view, tables);
    add_fetch_pass(plan, part, view, tables, sky_view, target);
    list.push_back(sky_view);
  }
  end_black_ground(plan, part, view);
  add_march_ground(plan, part, tables, target);
  return {target.radiance, list};
}

Quality with_table(std::string_view label, TableSize size, int steps) {
  return {label, {{"sky_view_lut", size}, {"steps", steps}}};
}

}  // namespace

SkyMethod sky_view_method() {
  SkyMethod method;
  method.info = {"sky-view", "a table of what the camera sees, one fetch a pixel [H20]", kParameters};
  method.info.knows_ground_maps = true;
  method.info.bends_light = true;
  method.validity.leaves_out =
      "direction and polarisation of light scattered more than once, and detail finer than its table (an aureole "
      "sharper than g = 0.9)";
  method.sweep = {with_table("24 x 18, 8 steps", {24, 18}, 8),
                  with_table("48 x 27, 16 steps", {48, 27}, 16),
                  with_table("96 x 54, 16 steps", {96, 54}, 16),
                  with_table("96 x 54", {96, 54}, 32),
                  with_table("192 x 108", {192, 108}, 32),
                  with_table("192 x 108, 128 steps", {192, 108}, 128),
                  with_table("384 x 216, 512 steps", {384, 216}, 512)};
  method.validity.sun_elevation_min = -6.0 * kDegree;
  method.validity.optical_depth_max = 5.0;
  method.validity.known_failures = march_table_failures();
  method.validity.known_failures.push_back(
      {"EJ",
       {{Quantity::view, -1, 0}, {Quantity::altitude, 0, 0.5}},
       "near the ground, the rows beside the horizon: the ground's distance changes faster than they resolve; "
       "render.ground_rays \"march\" mends it"});
  method.validity.known_failures.push_back(
      {"EJ",
       {{Quantity::sun_elevation, -90, 0}, {Quantity::planet_radius, 0, 20}},
       "a planet smaller than its air: the shadow's edge stands within the picture, sharper than the table's texels"});
  method.validity.known_failures.push_back(
      {"J",
       {{Quantity::sun_elevation, -0.1, 0.1}, {Quantity::altitude, 0, 0.5}, {Quantity::refractivity, 0, 5e-6}},
       "a sun at the horizon of air that hardly bends light: the edge of the planet's shadow lies in the level ray "
       "opposite, between two rows"});
  method.validity.known_failures.push_back({"EJ",
                                            {{Quantity::sun_elevation, -90, 0}, {Quantity::table_size, 0, 80}},
                                            "dusk: the shadow's edge is sharper than the texels of so coarse a table"});
  method.validity.known_failures.push_back(
      {"EJ", {{Quantity::asymmetry, -1, -0.9}}, "a glory sharper than the table's texels"});
  method.converged = converged_march();
  method.add_passes = add_sky_view;
  method.left_out = march_left_out;
  method.single_scattering = {{"multiple_scattering_scale", 0.0}};
  return method;
}

}  // namespace airlight
