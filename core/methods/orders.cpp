// `orders`: full multiple scattering from a small table of radiance moments found by successive orders of scattering,
// and the picture from a table of smooth factors multiplied by the phase functions at the pixel.

#include <algorithm>
#include <array>
#include <bit>

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "core/luts/luts.h"
#include "core/luts/moments.h"
#include "core/methods/ground_pass.h"
#include "core/methods/march_passes.h"
#include "core/methods/methods.h"
#include "core/methods/orders_parts.h"
#include "core/methods/sky_pass.h"
#include "core/methods/spectral_sums.h"
#include "core/scene/parameters.h"
#include "core/scene/thing_kinds.h"

namespace airlight {
namespace {

using orders::add_factors;
using orders::add_light;
using orders::add_table_constants;
using orders::factor_table;
using orders::FactorTable;
using orders::inside_the_air;
using orders::Light;
using orders::ray_cost;
using orders::settings_of;
using orders::steps_of;
using orders::stokes_of;
using orders::tabulates;

constexpr std::array<std::string_view, 10> kDegreeChoices{"auto", "0", "1", "2", "3", "4", "5", "6", "7", "8"};
constexpr std::array<std::string_view, 2> kFolded{"smooth", "all"};
constexpr std::array<std::string_view, 3> kWhen{"auto", "always", "never"};
constexpr std::array<std::string_view, 2> kCloudResolutions{"full", "half"};
constexpr std::array<std::string_view, 5> kShadows{"true", "froxels", "exact", "march", "false"};

const std::array<ParameterInfo, 14> kParameters{
    parameter::whole_number("steps", 4, 4096, 48, "steps along a view ray, apart at the planet's shadow"),
    parameter::table_size("transmittance_lut", 2, 4096, TableSize{256, 64}, "transmittance table, mu x h"),
    parameter::table_size(
        "moments_lut", 2, 1024, TableSize{48, 12},
        "table of radiance moments, sun elevations x altitudes; in hazy air, and by shells, of more altitudes"),
    parameter::choice("degree", kDegreeChoices, "auto",
                      "highest spherical harmonic kept; auto: 2, or where forward-peaked media are thick 5, in hazy "
                      "air and by shells 8"),
    parameter::whole_number("orders", 0, 64, 0,
                            "orders of scattering computed one by one before a geometric tail, at least 2; 0: as many "
                            "as the air needs, by shells all at once"),
    parameter::table_size(
        "sky_lut", 8, 2048, TableSize{24, 48},
        "table of the picture's light, azimuths x rows above level; limb and ground get 3/4 and 1/2 as many, the limb "
        "of a camera below 50 m fewer; from space there are 4 times as many columns, 2 times as many rows for the "
        "limb, 6 for the ground"),
    parameter::choice("fold", kFolded, "smooth",
                      "media that share a block of sky_lut with the diffuse light: those of a smooth phase function, "
                      "or all whose peak has a fifth of its height one column away, which saves a fetch a pixel and "
                      "blurs the aureole to the table"),
    parameter::choice(
        "tabulate", kWhen, "auto",
        "whether the picture's light is tabulated over view directions; always: over all of them; auto: over those of "
        "the picture, where it has no fewer pixels than the table has rays, from space 1.5 and at dusk four times as "
        "many"),
    parameter::whole_number(
        "aerial_slices", 4, 512, 16,
        "distances in the aerial volume of `airlight composite`, along directions two thirds as dense as sky_lut's"),
    parameter::choice(
        "shells", kWhen, "auto",
        "whether rays step through shells cut at the edges of the media; auto: where a medium that scatters ends "
        "abruptly or the vertical optical depth of scattering is above 1.2, in low fog 0.4"),
    parameter::choice(
        "volumetric_shadows", kShadows, "true",
        "how the air in the shadow of terrain and spheres is left without the sun's light; exact, true: where each ray "
        "crosses the shadows' edges; froxels: on a grid over picture and distance, four pixels a cell, which is faster "
        "and blurs beams; march: in each step of a march along each ray, the reference, among clouds as exact; false: "
        "not at all"),
    parameter::table_size(
        "cloud_lut", 4, 256, TableSize{90, 15},
        "cells of the light that a cloud scatters more than once, over the field's width and depth x upward; a carved "
        "field of fewer levels gets more cells across, as many in all"),
    parameter::choice("cloud_resolution", kCloudResolutions, "half",
                      "half: march through clouds at every second pixel each way and go between, but where their light "
                      "differs by 15 %, at edges, and in cube and octahedral maps"),
    phase_parameter()};

void settle(RenderSettings& settings, const Part& part) {
  const MomentSettings made = settings_of(part);
  settings.parameters.insert_or_assign("shells", std::string(made.shells ? "always" : "never"));
  settings.parameters.insert_or_assign("degree", std::to_string(made.degree));
}

std::vector<std::string> bounds(const Part& part) {
  const MomentSettings settings = settings_of(part);
  if (settings.orders == settings.wished_orders) {
    return {};
  }
  return {std::to_string(settings.orders) + " of " + std::to_string(settings.wished_orders) +
          " orders of scattering are computed: more would take too long at render.moments_lut " +
          std::to_string(settings.size[0]) + " x " + std::to_string(settings.size[1]) +
          "; a geometric tail stands for the rest, and nothing vouches for its error"};
}

// The ground by its maps, over a picture whose ground is black.
void add_ground(Plan& plan, const Part& part, const SkyTarget& target, const Light& light) {
  if (!part.scene.ground) {
    return;
  }
  GroundLight lit;
  lit.transmittance = light.transmittance;
  const MomentSettings settings = settings_of(part);
  std::vector<Specialization> constants = medium_specialization(part.air);
  add_moment_constants(constants, settings);
  lit.irradiance = add_moment_irradiance(plan, light.moments, constants);
  lit.constants = sunlight_specialization(plan, part.air, light.transmittance);
  add_moment_constants(lit.constants, settings);
  add_ground_map(plan, part, target, std::move(lit));
}

// The march along each pixel's ray.
void add_marched_sky(Plan& plan, const Part& part, const View& view, const SkyTarget& target, const Light& light) {
  std::vector<Specialization> constants = light.constants;
  constants.push_back({"kStokes", stokes_of(part, view)});
  constants.push_back({"kProjection", target.projection});
  constants.push_back({"kEdges", physics::kEdgesFound});
  std::vector<Binding> reads = light.reads();
  reads.push_back({"directions", target.directions});
  plan.add_pass({.name = "sky",
                 .shader = "sky_orders",
                 .reads = std::move(reads),
                 .writes = {{"radiance_out", target.radiance}},
                 .grid = target.grid,
                 .push_constants = {target.grid.width, target.grid.height, light.steps},
                 .specialization = std::move(constants),
                 .cost = ray_cost(light.steps)});
}

LayerPasses add_layers(Plan& plan, const Part& part, const View& view) {
  orders::refuse_around_clouds(part.scene, true);
  const Light light = add_light(plan, part);
  if (part.things.stand_in_the_air() || part.scene.ground) {
    return {orders::add_things_layers(plan, part, view, light), light.transmittance};
  }
  const bool tabulated = tabulates(part, view);
  std::vector<Binding> reads = light.reads();
  std::vector<Specialization> constants = light.constants;
  constants.push_back({"kEdges", physics::kEdgesFound});
  if (tabulated) {
    const FactorTable table = factor_table(part, part.air.scattering_media(), true, stokes_of(part, view));
    reads.push_back({"factors_lut", add_factors(plan, "layers_factors", part.scene, table, view, light)});
    add_table_constants(constants, table);
    constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  } else {
    add_layer_constants(constants, part);
  }
  constants.push_back({"kStokes", stokes_of(part, view)});
  const Extent grid = picture_grid(part.scene, view);
  const BufferId planes = add_layer_planes(plan, part, view);
  plan.add_pass({.name = "layers",
                 .shader = tabulated ? "layers_from_factors" : "layers_orders",
                 .reads = std::move(reads),
                 .writes = {{"layers_out", planes}},
                 .grid = grid,
                 .push_constants = {grid.width, grid.height, light.steps},
                 .specialization = std::move(constants)});
  if (!part.scene.clouds.empty()) {
    orders::add_clouds_to_layers(plan, part, view, light, planes);
  }
  return {planes, light.transmittance};
}

// Clouds through a polarising filter: of their layers, which have Q and U apart.
SkyPasses add_filtered_clouds(Plan& plan, const Part& part, const View& view) {
  if (!view.directions.empty()) {
    throw InputError(
        "clouds: the method \"orders\" probes no directions through a polarising filter among clouds; remove the "
        "filter or the clouds, or give the picture's quality in place of a tolerance");
  }
  View with_stokes = view;
  with_stokes.stokes = true;
  const LayerPasses layers = add_layers(plan, part, with_stokes);
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  std::vector<Specialization> constants = medium_specialization(part.air);
  constants.push_back({"kAirLayers", static_cast<std::uint32_t>(std::popcount(part.air.scattering_media())) + 1});
  constants.push_back({"kProjection", target.projection});
  constants.push_back({"kStokes", physics::kStokesFiltered});
  plan.add_pass({.name = "filter",
                 .shader = "layers_filtered",
                 .reads = {{"layers", layers.planes}},
                 .writes = {{"radiance_out", target.radiance}},
                 .grid = target.grid,
                 .push_constants = {target.grid.width, target.grid.height},
                 .specialization = std::move(constants)});
  return {target.radiance, {*layers.transmittance}, {}};
}

SkyPasses add_orders(Plan& plan, const Part& part, const View& view) {
  orders::refuse_around_clouds(part.scene, false);
  if (!part.scene.clouds.empty() && stokes_of(part, view) == physics::kStokesFiltered) {
    return add_filtered_clouds(plan, part, view);
  }
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  const Light light = add_light(plan, part);
  SkyPasses passes{target.radiance, {light.transmittance}, light.more()};
  if (part.things.stand_in_the_air() || (part.scene.ground && !part.scene.clouds.empty())) {
    if (part.scene.clouds.empty()) {
      orders::add_things_sky(plan, part, view, target, light);
      return passes;
    }
    const std::vector<orders::LitCloud> clouds = orders::add_cloud_light(plan, part, light);
    const auto things = orders::add_things_sky(plan, part, view, target, light, {.under = clouds});
    orders::add_clouds(plan, part, view, target, light, clouds, &things);
    return passes;
  }
  begin_black_ground(plan, part, view);
  if (tabulates(part, view)) {
    passes.more_tables.push_back(orders::add_tabulated_sky(plan, part, view, target, light));
  } else {
    add_marched_sky(plan, part, view, target, light);
  }
  end_black_ground(plan, part, view);
  add_ground(plan, part, target, light);
  if (!part.scene.clouds.empty()) {
    orders::add_clouds(plan, part, view, target, light, orders::add_cloud_light(plan, part, light), nullptr);
  }
  return passes;
}

// A table of the picture's light that would hold, but does not pay.
std::vector<std::string> left_out(const Scene& scene, const Plan& plan) {
  const bool tabulated =
      std::ranges::any_of(plan.images(), [](const ImageDesc& image) { return image.name.starts_with("sky_factors"); });
  if (tabulated || scene.terrain || has_bodies(scene) || scene.render.get<std::string>("tabulate") != "auto") {
    return {};
  }
  return {"table of the picture's light: the picture's " + std::to_string(scene.image.width * scene.image.height) +
          " pixels are too few to pay for it"};
}

RayFormula formula(physics::Physics p, const Part& part, const HostTables& tables) {
  const MomentSettings settings = settings_of(part);
  p.transmittance_lut = host_table(tables, "transmittance");
  p.moments_lut = host_table(tables, "moments");
  p.sun_table = host_table(tables, "sun_table");
  p.moment_columns = static_cast<physics::uint>(settings.size[0]);
  p.degree = static_cast<physics::uint>(settings.degree);
  p.delta = settings.delta;
  p.polarisation = settings.polarised;
  p.molecules_alone = settings.molecules_alone;
  return [p, by_shells = settings.shells,
          steps = steps_of(part.scene, settings)](const physics::Physics::Ray& ray) mutable {
    const physics::PlanetData& planet = p.scene.planet;
    const auto factors = by_shells ? p.shell_sky_factors(planet, p.scene.moments, ray, steps)
                                   : p.sky_factors(planet, p.scene.moments, ray, steps);
    return p.phased(factors, p.phases(ray.nu)) * p.scene.sun.irradiance;
  };
}

}  // namespace

SkyMethod orders_method() {
  SkyMethod method;
  method.info = {"orders", "successive orders of scattering as spherical-harmonic moments; near truth", kParameters};
  method.info.knows_terrain = true;
  method.info.knows_bodies = true;
  method.info.knows_ground_maps = true;
  method.info.knows_clouds = true;
  method.info.knows_polarisers = true;
  method.info.bends_light = true;
  method.info.misfits = orders::cloud_misfits;
  method.no_layers = orders::no_layers_of;
  method.validity.leaves_out =
      "harmonics above the degree kept, sunlight that waves throw into the air, and polarisation by other media than "
      "molecules";
  method.bounds = bounds;
  const std::string never = "never";
  const std::string all = "all";
  // Those between, and those that others beat, are on the chart, but cost a choice their shaders: no candidates.
  constexpr bool kOnlyCharted = false;
  method.sweep = {
      {"folded, degree 0, 6 steps, 8 x 12",
       {{"fold", all}, {"degree", std::string("0")}, {"steps", 6}, {"sky_lut", TableSize{8, 12}}},
       kOnlyCharted},
      {"folded, degree 0, 8 steps, 8 x 16",
       {{"fold", all}, {"degree", std::string("0")}, {"steps", 8}, {"sky_lut", TableSize{8, 16}}}},
      {"folded, 8 steps, 12 x 24", {{"fold", all}, {"steps", 8}, {"sky_lut", TableSize{12, 24}}}, kOnlyCharted},
      {"folded, 16 steps, 16 x 32", {{"fold", all}, {"steps", 16}, {"sky_lut", TableSize{16, 32}}}},
      {"folded", {{"fold", all}}, kOnlyCharted},
      {"16 steps, 16 x 32", {{"steps", 16}, {"sky_lut", TableSize{16, 32}}}, kOnlyCharted},
      {"degree 0", {{"degree", std::string("0")}}, kOnlyCharted},
      {"degree 1", {{"degree", std::string("1")}}, kOnlyCharted},
      {"16 steps", {{"steps", 16}}, kOnlyCharted},
      {"default", {}},
      {"96 steps, 48 x 96", {{"steps", 96}, {"sky_lut", TableSize{48, 96}}}},
      {"degree 6, 96 steps, 48 x 96", {{"degree", std::string("6")}, {"steps", 96}, {"sky_lut", TableSize{48, 96}}}},
      {"16 steps, each pixel", {{"steps", 16}, {"tabulate", never}}},
      {"48 steps, each pixel", {{"steps", 48}, {"tabulate", never}}},
      {"degree 6, 128 steps, each pixel", {{"degree", std::string("6")}, {"steps", 128}, {"tabulate", never}}},
      {"degree 6, 128 steps, large tables, each pixel",
       {{"degree", std::string("6")},
        {"steps", 128},
        {"tabulate", never},
        {"moments_lut", TableSize{96, 24}},
        {"transmittance_lut", TableSize{512, 128}}}}};
  method.validity.optical_depth_max = 5.0;
  method.validity.known_failures = {
      {"EJ", {{Quantity::steps, 0, 16}}, "few steps"},
      {"EJ", {{Quantity::table_size, 0, 40}}, "coarse tables"},
      {"E",
       {{Quantity::sun_elevation, -90, -15}, {Quantity::altitude, 0, 150}},
       "night: the last light of dusk comes from air that few of the table's altitudes stand in"},
      {"EJ",
       {{Quantity::sun_elevation, -90, 0}, {Quantity::optical_depth, 0, 5}, {Quantity::light_kept, 0.99, 1}},
       "dusk in air without ozone over a white ground: its light comes from a narrow rim that the table of moments "
       "does not resolve"},
      {"EJ",
       {{Quantity::sun_elevation, -90, 0}, {Quantity::planet_radius, 1e4, 1e9}},
       "a planet so large that dusk passes within a degree: too few of the table's sun elevations stand in it"},
      {"G",
       {{Quantity::asymmetry, -1, -0.95}, {Quantity::optical_depth, 0.05, 1e9}, {Quantity::light_kept, 0.99, 1}},
       "haze that absorbs nothing and scatters sharply back, over a white ground: harmonics of degree 2 do not hold "
       "what goes to and fro between the two"},
      rounding_at_the_horizon(),
      dark_air_over_waves()};
  method.converged = {"",
                      {{"steps", 1024},
                       {"transmittance_lut", TableSize{512, 128}},
                       {"moments_lut", TableSize{96, 24}},
                       {"cloud_resolution", std::string("full")}}};
  method.add_passes = add_orders;
  method.add_coloured_passes = orders::add_coloured;
  method.settle = settle;
  method.add_layer_passes = add_layers;
  method.has_stokes = true;
  method.add_span_passes = orders::add_spans;
  // The volume holds no shadows.
  method.has_volume = [](const Scene& scene) {
    return inside_the_air(scene) && !scene.terrain && !has_bodies(scene) && scene.clouds.empty();
  };
  method.all_tables.emplace_back("tabulate", std::string("always"));
  method.left_out = left_out;
  method.formula = formula;
  return method;
}

}  // namespace airlight
