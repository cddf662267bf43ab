#include "core/library/validity.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/methods/known_failures.h"
#include "core/methods/ready.h"
#include "core/scene/angle.h"
#include "core/scene/cloud_pixels.h"
#include "core/scene/curve_reader.h"
#include "core/scene/thing_kinds.h"

namespace airlight {
namespace {

// The stage of the light that makes the picture: of a sun more than 18 degrees down nothing shows beside the moon's.
const Stage& leading(const Stage& stage) {
  constexpr double kNight = -18.0 * kDegree;
  const auto is_up = [](const Stage& other) { return other.scene().sun.elevation > 0.0; };
  const auto up = std::ranges::find_if(stage.others(), is_up);
  return stage.scene().sun.elevation < kNight && up != stage.others().end() ? *up : stage;
}

// Of the sun's light. From there on the light that comes from beyond the shadow counts.
constexpr double kDeepEclipse = 0.05;

std::string methods_that_hold(const Stage& stage) {
  const Scene& scene = stage.scene();
  return joined_of(methods(), [&](const SkyMethod& method) {
    const Scene rendered = scene.render.method == method.info.name ? scene : with_quality(scene, method, {});
    const bool holds = knows_things_of(method.info, scene) && exceeded_limits(method.validity, stage).empty() &&
                       known_failures_of(method, ready(rendered, stage).whole()).empty();
    return holds ? method.info.name : std::string_view();
  });
}

}  // namespace

std::vector<std::string> exceeded_limits(const Validity& validity, const Stage& stage) {
  const Scene& scene = stage.scene();
  std::vector<std::string> limits;
  if (scene.sun.elevation < validity.sun_elevation_min) {
    limits.push_back("a sun below " + rounded(degrees_from_radians(validity.sun_elevation_min), 4) +
                     " degrees (it is at " + rounded(degrees_from_radians(scene.sun.elevation), 4) + ")");
  }
  if (scene.camera.altitude > validity.altitude_max) {
    limits.push_back("a camera above " + rounded(validity.altitude_max, 4) + " km (it is at " +
                     rounded(scene.camera.altitude, 4) + ")");
  }
  const double depth = stage.whole().air.depths().extinction;
  if (depth > validity.optical_depth_max) {
    limits.push_back("air of a vertical optical depth above " + rounded(validity.optical_depth_max, 4) + " (it is " +
                     rounded(depth, 4) + ")");
  }
  return limits;
}

std::string validity_warning(const Stage& of) {
  const Stage& stage = leading(of);
  const Validity& validity = stage.method().validity;
  const std::string reasons = joined(exceeded_limits(validity, stage), ", nor for ");
  if (reasons.empty()) {
    return {};
  }
  std::string text = "method " + stage.scene().render.method + " does not claim to hold for " + reasons;
  text += validity.leaves_out.empty() ? "" : "; it leaves out " + std::string(validity.leaves_out);
  const std::string better = methods_that_hold(stage);
  return text + (better.empty() ? "" : "; methods that do: " + better);
}

std::string known_failure_warning(const Stage& of) {
  const Stage& stage = leading(of);
  const std::string causes = joined(known_failures_of(stage.method(), stage.whole()), "; ");
  if (causes.empty()) {
    return {};
  }
  const std::string better = methods_that_hold(stage);
  return "method " + stage.scene().render.method + " is known to be wrong here: " + causes +
         (better.empty() ? "" : "; methods that hold: " + better);
}

std::vector<std::string> bound_warnings(const Stage& stage) {
  const auto bounds = stage.method().bounds;
  return bounds == nullptr ? std::vector<std::string>() : bounds(stage.whole());
}

std::vector<std::string> scene_warnings(const Stage& stage, bool error_is_measured) {
  std::vector<std::string> warnings = bound_warnings(stage);
  if (std::string claim = validity_warning(stage); !claim.empty()) {
    warnings.insert(warnings.begin(), std::move(claim));
  } else if (std::string failure = error_is_measured ? std::string() : known_failure_warning(stage); !failure.empty()) {
    warnings.insert(warnings.begin(), std::move(failure));
  }
  if (const Sun& sun = stage.scene().sun; sun.disc.cover && sun.uncovered < kDeepEclipse) {
    warnings.push_back("the moon leaves " + rounded(100.0 * sun.uncovered, 2) +
                       " % of the sun's light here, and everywhere else as much: the air beyond the moon's shadow, "
                       "which then lights the sky, and the corona are left out");
  }
  for (const auto& more : {curve_warnings(stage.scene()), cloud_warnings(stage.scene())}) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
  return warnings;
}

}  // namespace airlight
