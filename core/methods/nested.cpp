// `nested`: the view march with a sun march inside it; single scattering, no tables [N93, O05].

#include <array>
#include <string>

#include "core/base/error.h"
#include "core/luts/luts.h"
#include "core/methods/march_passes.h"
#include "core/methods/marched_picture.h"
#include "core/methods/methods.h"
#include "core/physics/physics.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

const std::array<ParameterInfo, 7> kParameters{
    steps_parameter(16),
    parameter::whole_number("sun_steps", 1, 4096, 8, "steps toward the sun from each step of the view ray"),
    step_distribution_parameter(),
    jitter_parameter(),
    resolution_parameter(),
    phase_parameter(),
    sun_fade_parameter()};

// The software device (Mesa's llvmpipe) silently ends a shader's loops after 65535 turns of all of them together.
constexpr long long kMostTurns = 65535;

void refuse_too_many_turns(long long steps, long long sun_steps) {
  if (steps * (sun_steps + 1) > kMostTurns) {
    throw InputError("render: nested takes steps x (sun_steps + 1) up to " + std::to_string(kMostTurns) + ", not " +
                     std::to_string(steps) + " x " + std::to_string(sun_steps + 1) + "; lower either");
  }
}

// Whether the several rays of a pixel at the planet's edge fit into these turns; otherwise the pixel is its middle's
// ray.
bool fits_edges(const Scene& scene) {
  const bool from_space = scene.camera.altitude > scene.planet.atmosphere_height;
  const long long rays = from_space ? physics::Physics{}.kRingStrips + 1 : 2;
  const long long turns = scene.render.get<int>("steps") * (scene.render.get<int>("sun_steps") + 1LL);
  return rays * turns <= kMostTurns;
}

std::vector<Specialization> constants_of(const Part& part) {
  std::vector<Specialization> constants = medium_specialization(part.air);
  constants.push_back({"kEdges", fits_edges(part.scene) ? physics::kEdgesFound : physics::kEdgesLeftOut});
  constants.push_back({"kGroundReflects", part.air.ground_reflects() ? 1u : 0u});
  constants.push_back({"kStepDistribution", step_distribution_code(part.scene)});
  return constants;
}

// The push constants after the grid's sides: the numbers of steps.
std::vector<std::uint32_t> push_constants_of(const Scene& scene) {
  const int steps = scene.render.get<int>("steps");
  const int sun_steps = scene.render.get<int>("sun_steps");
  refuse_too_many_turns(steps, sun_steps);
  return {static_cast<std::uint32_t>(steps), static_cast<std::uint32_t>(sun_steps)};
}

SkyPasses add_nested(Plan& plan, const Part& part, const View& view) {
  const SkyTarget target = add_sky_target(plan, part.scene, view);
  add_marched_picture(
      plan, part.scene,
      {.shader = "sky_nested",
       .push_constants = push_constants_of(part.scene),
       .specialization = constants_of(part),
       .cost = 4.0 + part.scene.render.get<int>("steps") * (1.0 + part.scene.render.get<int>("sun_steps"))},
      target);
  return {target.radiance, {}};
}

std::vector<std::string> left_out(const Scene&, const Plan&) {
  return {"multiple scattering: it adds less than the tolerance"};
}

RayFormula formula(physics::Physics p, const Part& part, const HostTables&) {
  p.sun_steps = static_cast<physics::uint>(part.scene.render.get<int>("sun_steps"));
  p.multiple_scattering_lut = {1, 1, {physics::vec3(0.0)}};
  p.ground_irradiance_lut = {1, 1, {physics::vec3(0.0)}};
  const auto steps = static_cast<physics::uint>(part.scene.render.get<int>("steps"));
  return [p, steps, distribution = step_distribution_code(part.scene),
          place = place_in_step(part.scene)](const physics::Physics::Ray& ray) mutable {
    return p.march_at(p.scene.planet, p.scene.sun, ray, steps, distribution, place, 0.0).radiance;
  };
}

Quality with_steps(std::string_view label, int steps, int sun_steps) {
  return {label, {{"steps", steps}, {"sun_steps", sun_steps}}};
}

}  // namespace

SkyMethod nested_method() {
  SkyMethod method;
  method.info = {"nested", "view march with a sun march inside, single scattering, no tables [N93, O05]", kParameters};
  method.validity.leaves_out = "light scattered more than once, and the sky's light on the ground";
  method.sweep = {with_steps("4 x 2", 4, 2), with_steps("8 x 4", 8, 4), with_steps("16 x 8", 16, 8),
                  with_steps("32 x 8", 32, 8), with_steps("64 x 16", 64, 16)};
  method.validity.error = 0.05;
  method.validity.optical_depth_max = 1.0;
  method.validity.known_failures = {
      {"EJ", {{Quantity::steps, 0, 16}}, "few steps"},
      {"EJ",
       {{Quantity::optical_depth, 0.3, 1e9}},
       "thick air: steps stand by geometry, not by depth; more render.steps and render.sun_steps mend it"},
      {"EJ", {{Quantity::sun_elevation, -90, 2}}, "dusk: 16 steps straddle the edge of the planet's shadow"},
      {"R",
       {{Quantity::sun_elevation, -0.001, 0.001}, {Quantity::altitude, 0, 1e-4}},
       "the sun on the horizon of a camera on the ground: rounding decides which steps it lights"},
      {"EJ",
       {{Quantity::sun_elevation, 2, 10}, {Quantity::planet_radius, 1e4, 1e9}},
       "a low sun over a large planet: 8 steps toward it do not resolve the air that it grazes"},
      {"L",
       {{Quantity::optical_depth, 0.05, 1e9}, {Quantity::light_kept, 0.99, 1}},
       "single scattering: what is scattered again is lost"},
      {"J",
       {{Quantity::view, -0.05, 1}, {Quantity::altitude, 1, 1e9}},
       "the limb from above: 16 steps do not resolve the air around the ray's lowest point"},
      rounding_at_the_horizon()};
  method.converged = {"", {{"steps", 512}, {"sun_steps", 120}}};
  method.add_passes = add_nested;
  method.left_out = left_out;
  method.formula = formula;
  return method;
}

}  // namespace airlight
