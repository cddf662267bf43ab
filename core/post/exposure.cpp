// Automatic exposure as an eye adapts [W94]: full by day, less and less in twilight, ending in the night.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/post/post.h"
#include "core/scene/photometry.h"

namespace airlight {
namespace {

// What the meter reads by day comes out at this, which the default view shows as sRGB 127 (0.265 as 118, 0.18 as 91).
// A camera's meter takes what it sees for a grey card, sRGB 118. Most of what this one sees is sky: a sixth of a stop
// more shows that as photographs do. At noon a grey card that lies in the sun is at 157, one that stands at 71.
constexpr double kDay = 0.30;
// Luminance of a clear sky at noon, cd/m2, which is shown so.
constexpr double kNoon = 3000.0;

// The least difference in luminance that an eye adapted to so many cd/m2 sees [W94], after Blackwell's data, up to a
// constant factor.
double least_seen(double luminance) {
  return std::pow(1.219 + std::pow(luminance, 0.4), 2.5);
}

// Exposure per cd/m2. A just visible difference is shown like a just visible one at noon: in proportion to 1/luminance
// by day. Below some cd/m2 it hardly rises any more and ends at 0.20.
double adapted_exposure(double luminance) {
  return kDay / kNoon * least_seen(kNoon) / least_seen(luminance);
}

// The same by the rods, which see where the eye's cones no longer do (Ferwerda, Pattanaik, Shirley and Greenberg,
// SIGGRAPH 1996): their threshold, in proportion to luminance above 0.04 cd/m2, ends at 1e-4.
double rods_exposure(double luminance) {
  const auto by_cones = [](double log_luminance) { return std::pow(10.0, log_luminance - 1.255); };
  const double x = std::log10(std::max(luminance, 1e-30));
  double threshold = -2.86;
  if (x >= -1.44) {
    threshold = x - 0.395;
  } else if (x > -3.94) {
    threshold += std::pow(0.405 * x + 1.6, 2.18);
  }
  return kDay / kNoon * by_cones(std::log10(kNoon)) / std::pow(10.0, threshold);
}

// The factor that the scene wishes for by night. It comes as slowly as the rods leave room for: up to 3 stops a darker
// picture is never shown brighter.
double night_gain(const Display& display, double luminance) {
  constexpr double kNight = 2e-4;  // cd/m2
  constexpr double kDusk = 0.02;
  const double share = std::log10(kDusk / std::max(luminance, 1e-30)) / std::log10(kDusk / kNight);
  return std::exp2(display.night * std::pow(std::clamp(share, 0.0, 1.0), 2.0));
}

// Whether the scene has a light of the night, which an eye in the dark would see.
bool has_night(const Scene& scene) {
  return scene.moon || scene.night_sky || scene.stars;
}

}  // namespace

double exposure_for(const Scene& scene, const Statistics& statistics) {
  const double gain = std::exp2(scene.display.compensation);
  if (scene.display.exposure) {
    return gain * *scene.display.exposure;
  }
  const double one = luminance_of_one(scene);
  const double luminance = one * statistics.metered_luminance;
  if (!(one > 0.0)) {
    return gain;
  }
  const double adapted = adapted_exposure(luminance);
  return gain * night_gain(scene.display, luminance) * one *
         (has_night(scene) ? std::max(adapted, rods_exposure(luminance)) : adapted);
}

double brightest_metered(const Scene& scene) {
  const double sun = bt709_luminance(scene.sun.irradiance);
  return sun > 0.0 ? std::min<double>(sun / std::numbers::pi, std::numeric_limits<float>::max())
                   : std::numeric_limits<float>::max();
}

}  // namespace airlight
