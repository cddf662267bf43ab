#include "core/methods/marched_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/methods/march_steps.h"
#include "core/physics/physics.h"
#include "core/scene/angle.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

constexpr std::array<std::string_view, 3> kJitters{"none", "fixed", "blue-noise"};
constexpr std::array<std::string_view, 3> kResolutions{"full", "half", "auto"};

// A method without the key uses the key's default.
std::string choice_of(const Scene& scene, const std::string& key, std::string_view otherwise) {
  const auto found = scene.render.parameters.find(key);
  return found == scene.render.parameters.end() ? std::string(otherwise) : std::get<std::string>(found->second);
}

// kJitters are in the order of the codes physics::kJitterNone, ...; listed directions have no pixel. Throws InputError.
std::uint32_t jitter_code(const Scene& scene, bool listed) {
  const std::string jitter = choice_of(scene, "jitter", "none");
  const auto code = static_cast<std::uint32_t>(std::ranges::find(kJitters, jitter) - kJitters.begin());
  if (code != physics::kJitterNone && step_distribution_code(scene) == physics::kStepsGaussLegendre) {
    throw InputError("render: jitter \"" + jitter +
                     "\" moves the places of light within their steps, but those of step_distribution "
                     "\"gauss-legendre\" stand where the rule needs them; remove either");
  }
  return listed && code == physics::kJitterBlueNoise ? physics::kJitterNone : code;
}

// Between corners further apart than twice this a sky is no longer nearly linear, and nothing would be saved.
constexpr double kCoarsestPixel = 2.0 * kDegree;

// Greatest angle from a pixel to the next.
double greatest_pixel_angle(const Scene& scene) {
  const double width = scene.image.width;
  const double height = scene.image.height;
  switch (scene.camera.projection) {
    case Projection::equirectangular:
      return std::max(2.0 * std::numbers::pi / width, std::numbers::pi / height);
    case Projection::fisheye:
      return scene.camera.vertical_fov / std::min(width, height);
    case Projection::cube:
    case Projection::octahedral:
      return std::numbers::pi;  // no interpolation across a map's cuts
    case Projection::perspective:
      break;
  }
  return 2.0 * std::tan(0.5 * scene.camera.vertical_fov) / height;
}

// For pixels finer than this the error of the half resolution itself is some hundredths of the march's: 0.002 to 0.006
// % in the mean.
constexpr double kFinePixel = 0.15 * kDegree;

PassDesc part_of(PassDesc pass, std::uint32_t part, Extent grid, BufferId out, BufferId corners) {
  pass.name = part == physics::kPartHalf ? "sky_half" : "sky";
  pass.grid = grid;
  pass.push_constants.insert(pass.push_constants.begin(), {grid.width, grid.height});
  pass.specialization.push_back({"kPart", part});
  pass.reads.push_back({"half_radiance", corners});
  pass.writes.push_back({"radiance_out", out});
  return pass;
}

}  // namespace

ParameterInfo jitter_parameter() {
  return parameter::choice(
      "jitter", kJitters, "none",
      "where in a step its light is taken, against bands at few steps: none, in the middle; fixed, at 0.3; blue-noise, "
      "at a place of its own for each pixel; not with step_distribution gauss-legendre");
}

ParameterInfo resolution_parameter() {
  return parameter::choice("resolution", std::span(kResolutions).first(2), "full",
                           "half: march at every second pixel each way and go bilinearly between, but at edges, steep "
                           "places, pixels wider than 2 degrees, and cube and octahedral maps");
}

ParameterInfo automatic_resolution_parameter() {
  return parameter::choice("resolution", kResolutions, "auto",
                           "half: march at every second pixel each way and go bilinearly between, but at edges, steep "
                           "places, pixels wider than 2 degrees, and cube and octahedral maps; auto: half where pixels "
                           "are finer than 0.15 degrees and the steps are left to the scene");
}

bool halves(const Scene& scene) {
  const std::string resolution = choice_of(scene, "resolution", "full");
  const bool fine = steps_are_automatic(scene.render) && greatest_pixel_angle(scene) <= kFinePixel;
  return (resolution == "half" && greatest_pixel_angle(scene) <= kCoarsestPixel) || (resolution == "auto" && fine);
}

double place_in_step(const Scene& scene) {
  return jitter_code(scene, true) == physics::kJitterFixed ? physics::Physics{}.kFixedPlace : 0.5;
}

void add_marched_picture(Plan& plan, const Scene& scene, PassDesc pass, const SkyTarget& target) {
  const bool listed = target.projection == physics::kProjectionListed;
  pass.specialization.push_back({"kProjection", target.projection});
  pass.specialization.push_back({"kJitter", jitter_code(scene, listed)});
  pass.reads.push_back({"directions", target.directions});
  if (listed || !halves(scene)) {
    plan.add_pass(part_of(std::move(pass), physics::kPartWhole, target.grid, target.radiance, target.directions));
    return;
  }
  const Extent corners{target.grid.width / 2 + 2, target.grid.height / 2 + 2, 1};
  const BufferId half = plan.add_buffer({.name = "half_radiance",
                                         .bytes = std::size_t{corners.width} * corners.height * 4 * sizeof(float),
                                         .zeroed = false});
  plan.add_pass(part_of(pass, physics::kPartHalf, corners, half, target.directions));
  plan.add_pass(part_of(std::move(pass), physics::kPartUpsampled, target.grid, target.radiance, half));
}

}  // namespace airlight
