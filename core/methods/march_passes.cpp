#include "core/methods/march_passes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/luts/luts.h"
#include "core/luts/moments.h"
#include "core/methods/ground_pass.h"
#include "core/methods/marched_picture.h"
#include "core/methods/methods.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

constexpr std::string_view kScale = "multiple_scattering_scale";
using parameter::kNoLimit;
constexpr std::array<std::string_view, 2> kPhases{"media", "schlick"};

}  // namespace

ParameterInfo phase_parameter() {
  return parameter::choice(
      "phase", kPhases, "media",
      "schlick: Schlick's rational form in place of Henyey-Greenstein and Cornette-Shanks, whatever the media say");
}

ParameterInfo transmittance_lut_parameter() {
  return parameter::table_size("transmittance_lut", 2, 4096, TableSize{256, 64}, "transmittance table, mu x h");
}

ParameterInfo multiple_scattering_lut_parameter() {
  return parameter::table_size("multiple_scattering_lut", 2, 4096, TableSize{32, 32},
                               "multiple-scattering table, mu_sun x h");
}

ParameterInfo multiple_scattering_scale_parameter() {
  return parameter::number(kScale, 1.0, "1: physics; 0: single scattering alone; 4 pi: a published lesson's");
}

ParameterInfo sun_fade_parameter() {
  return {"sun_fade",
          ParameterKind::sun_fade,
          -kNoLimit,
          kNoLimit,
          std::monostate{},
          {},
          "a published lesson's clamp(scale mu_sun + bias, 0, 1) on direct light; absent: the planet's shadow alone"};
}

namespace {

constexpr std::string_view kFewRows =
    "thick air over a white ground, haze that throws light back sooner: too few rows of the table of multiple "
    "scattering stand near the ground; 48 in render.multiple_scattering_lut mend it, more steps do not";

}  // namespace

std::vector<KnownFailure> march_table_failures() {
  using enum Quantity;
  return {
      {"EJ", {{steps, 0, 16}}, "few steps"},
      {"EJ", {{table_size, 0, 40}}, "coarse tables"},
      {"EJ", {{optical_depth, 0.15, 1e9}, {light_kept, 0.99, 1}}, kFewRows},
      {"EJ",
       {{sun_elevation, -90, -2}},
       "late dusk: the table of multiple scattering has too few columns where light falls by a factor a degree; a "
       "wider render.multiple_scattering_lut mends it"},
      {"EJ",
       {{sun_elevation, -90, 0}, {planet_radius, 1e4, 1e9}},
       "a planet so large that dusk passes within a degree: too few of the table's columns stand in it"},
      {"G",
       {{optical_depth, 0.005, 10}, {light_kept, 0.99, 1}},
       "a white ground under air that absorbs nothing: multiple scattering takes the light as equal in all directions "
       "and heights, so that the ground sends up more than reaches it"},
      dark_air_over_waves()};
}

std::vector<KnownFailure> march_failures() {
  std::vector<KnownFailure> all = march_table_failures();
  using enum Quantity;
  all.push_back({"EJ", {{optical_depth, 0.09, 1e9}, {light_kept, 0.99, 1}, {asymmetry, -1, -0.95}}, kFewRows});
  all.push_back(rounding_at_the_horizon());
  return all;
}

Converged converged_march() {
  return {"march",
          {{"steps", 1024},
           {"step_distribution", std::string("quadratic")},
           {"resolution", std::string("full")},
           {"transmittance_lut", TableSize{512, 128}},
           {"multiple_scattering_lut", TableSize{128, 48}}}};
}

std::vector<ImageId> MarchTables::list() const {
  std::vector<ImageId> tables{transmittance, multiple_scattering};
  if (reflects) {
    tables.push_back(ground_irradiance);
  }
  return tables;
}

MarchTables add_march_tables(Plan& plan, const Part& part) {
  const RenderSettings& settings = part.scene.render;
  MarchTables tables;
  tables.transmittance = add_transmittance(plan, part.air, settings.get<TableSize>("transmittance_lut"));
  // A table that is scaled by 0 need only be large enough to be bound.
  const bool single = settings.get<double>(kScale) == 0.0;
  tables.multiple_scattering =
      add_multiple_scattering(plan, part.air, tables.transmittance,
                              single ? TableSize{2, 2} : settings.get<TableSize>("multiple_scattering_lut"));
  tables.reflects = part.air.ground_reflects();
  tables.ground_irradiance =
      tables.reflects ? add_ground_irradiance(plan, part.air, tables.transmittance, tables.multiple_scattering)
                      : tables.multiple_scattering;
  return tables;
}

std::vector<Specialization> march_specialization(const Plan& plan, const Part& part, const MarchTables& tables) {
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, tables.transmittance);
  add_scattering_size(constants, plan, tables.multiple_scattering);
  constants.push_back({"kStepDistribution", march_steps(part).distribution});
  return constants;
}

double march_cost(int steps) {
  return 4.0 + steps;
}

std::vector<std::string> march_left_out(const Scene& scene, const Plan&) {
  if (scene.render.get<double>(kScale) > 0.0) {
    return {};
  }
  return {"multiple scattering: the air is so thin that it adds less than the tolerance"};
}

physics::HostTable host_table(const HostTables& tables, const std::string& name) {
  const auto found = tables.find(name);
  return found == tables.end() ? physics::HostTable() : found->second;
}

RayFormula march_formula(physics::Physics p, const Part& part, const HostTables& tables) {
  p.transmittance_lut = host_table(tables, "transmittance");
  p.multiple_scattering_lut = host_table(tables, "multiple_scattering");
  p.ground_irradiance_lut = host_table(tables, "ground_irradiance");
  return [p, steps = march_steps(part), place = place_in_step(part.scene)](const physics::Physics::Ray& ray) mutable {
    return p
        .march_at(p.scene.planet, p.scene.sun, ray, static_cast<physics::uint>(steps.count), steps.distribution, place,
                  p.scene.multiple_scattering_scale)
        .radiance;
  };
}

std::vector<Binding> march_reads(const MarchTables& tables) {
  return {{"transmittance_lut", tables.transmittance}, {"multiple_scattering_lut", tables.multiple_scattering}};
}

void add_march_pass(Plan& plan, const Part& part, const MarchTables& tables, const SkyTarget& target) {
  std::vector<Specialization> constants = march_specialization(plan, part, tables);
  constants.push_back({"kGroundReflects", tables.reflects ? 1u : 0u});
  constants.push_back({"kEdges", physics::kEdgesFound});
  std::vector<Binding> reads = march_reads(tables);
  reads.push_back({"ground_irradiance_lut", tables.ground_irradiance});
  const int steps = march_steps(part).count;
  add_marched_picture(plan, part.scene,
                      {.shader = "sky_march",
                       .reads = std::move(reads),
                       .push_constants = {static_cast<std::uint32_t>(steps)},
                       .specialization = std::move(constants),
                       .cost = march_cost(steps)},
                      target);
}

void add_march_ground(Plan& plan, const Part& part, const MarchTables& tables, const SkyTarget& target) {
  std::vector<Specialization> constants = sunlight_specialization(plan, part.air, tables.transmittance);
  add_moment_constants(constants, {});  // no part of a peak is taken as unscattered
  add_ground_map(plan, part, target,
                 {.transmittance = tables.transmittance,
                  .irradiance = tables.ground_irradiance,
                  .sky = tables.reflects,
                  .constants = std::move(constants)});
}

}  // namespace airlight
