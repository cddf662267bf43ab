// `analytic`: closed-form skies, no march and no table.

#include <array>

#include "core/luts/luts.h"
#include "core/methods/analytic_sky.h"
#include "core/methods/march_passes.h"
#include "core/methods/methods.h"
#include "core/methods/sky_pass.h"
#include "core/plan/bytes.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

constexpr std::array<std::string_view, 2> kVariants{"zenith-density", "exponential"};

const std::array<ParameterInfo, 1> kParameters{
    parameter::choice("variant", kVariants, "exponential",
                      "zenith-density: one even layer, its density along a ray a fit in the zenith cosine; "
                      "exponential: each medium's own column, in-scattering and aerial perspective by exponentials")};

bool is_exponential(const Scene& scene) {
  return scene.render.get<std::string>("variant") == "exponential";
}

SkyPasses add_analytic(Plan& plan, const Part& part, const View& view) {
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  const BufferId data =
      plan.add_buffer(filled_buffer("analytic", analytic_bytes(make_analytic_physics(part).analytic)));
  std::vector<Specialization> constants = medium_specialization(part.air);
  constants.push_back({"kProjection", target.projection});
  constants.push_back(
      {"kVariant", is_exponential(part.scene) ? physics::kAnalyticExponential : physics::kAnalyticZenithDensity});
  constants.push_back({"kEdges", physics::kEdgesFound});
  constants.push_back({"kScatteringMedia", part.air.scattering_media()});
  plan.add_pass({.name = "sky",
                 .shader = "sky_analytic",
                 .reads = {{"analytic", data}, {"directions", target.directions}},
                 .writes = {{"radiance_out", target.radiance}},
                 .grid = target.grid,
                 .push_constants = {target.grid.width, target.grid.height},
                 .specialization = std::move(constants),
                 .cost = 5.0});
  return {target.radiance, {}};
}

RayFormula formula(physics::Physics p, const Part& part, const HostTables&) {
  physics::Physics closed = make_analytic_physics(part);
  closed.scene.sun = p.scene.sun;
  return [closed, exponential = is_exponential(part.scene)](const physics::Physics::Ray& ray) mutable {
    const physics::PlanetData& planet = closed.scene.planet;
    const physics::SunData& sun = closed.scene.sun;
    return exponential ? closed.analytic_exponential(planet, sun, ray, sun.direction.y).radiance
                       : closed.analytic_zenith_density(planet, sun, ray).radiance;
  };
}

Quality with_variant(std::string_view name) {
  return {name, {{"variant", std::string(name)}}};
}

}  // namespace

SkyMethod analytic_method() {
  SkyMethod method;
  method.info = {"analytic", "closed-form sky: no march, no table", kParameters};
  method.validity.sun_elevation_min = 0.0;
  method.validity.altitude_max = 10.0;
  method.validity.optical_depth_max = 1.0;
  method.validity.leaves_out =
      "the density profiles' shapes beyond mean and spread, direction and polarisation of light scattered more than "
      "once, twilight";
  method.sweep = {with_variant("zenith-density"), with_variant("exponential")};
  method.validity.error = 0.2;
  method.validity.known_failures = {
      rounding_at_the_horizon(),
      {"GL",
       {{Quantity::optical_depth, 0.005, 1e9}, {Quantity::light_kept, 0.99, 1}},
       "closed forms that no balance of energy ties together"},
      {"J", {{Quantity::sun_elevation, 0, 4}}, "sunset: closed forms of the ground's shadow in place of the air's own"},
      {"E", {{Quantity::planet_radius, 0, 5}}, "a planet smaller than its air: its columns are fits for thin shells"},
      {"EJ",
       {{Quantity::view, -1, 1}, {Quantity::altitude, 0.0005, 1e9}},
       "the horizon from above the ground: a column across it is the difference of two fits"}};
  method.converged = converged_march();
  method.add_passes = add_analytic;
  method.formula = formula;
  return method;
}

}  // namespace airlight
