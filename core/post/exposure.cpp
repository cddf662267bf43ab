// Automatic exposure as an eye adapts [W94]: full by day, less and less in twilight, at an end in the night.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/post/post.h"
#include "core/scene/photometry.h"

namespace airlight {
namespace {

constexpr double kMiddleGrey = 0.18;
// cd/m2 of a clear sky at noon, which the meter brings to middle grey.
constexpr double kNoon = 3000.0;

// cd/m2 of the radiance (1, 1, 1); 0: there is no light to tell by. A sun of no unit counts as Earth's, whatever its
// number: the exposure follows the picture's look, not its unit.
double luminance_of_one(const Scene& scene) {
  const double sun = bt709_luminance(scene.sun.irradiance);
  return white_luminance(scene.sun.unit).value_or(sun > 0.0 ? kSunlight / sun : 0.0);
}

// The least difference in luminance that an eye adapted to so many cd/m2 sees [W94], after Blackwell's data, but for
// a constant factor.
double least_seen(double luminance) {
  return std::pow(1.219 + std::pow(luminance, 0.4), 2.5);
}

// Per cd/m2. What is just seen there is shown as what is just seen at noon: in proportion to 1/luminance by day, and
// below some cd/m2 hardly more than at none, where it ends at 0.12.
double adapted_exposure(double luminance) {
  return kMiddleGrey / kNoon * least_seen(kNoon) / least_seen(luminance);
}

}  // namespace

double exposure_for(const Scene& scene, const Statistics& statistics) {
  const double gain = std::exp2(scene.display.compensation);
  if (scene.display.exposure) {
    return gain * *scene.display.exposure;
  }
  const double one = luminance_of_one(scene);
  return one > 0.0 ? gain * one * adapted_exposure(one * statistics.metered_luminance) : gain;
}

double brightest_metered(const Scene& scene) {
  const double sun = bt709_luminance(scene.sun.irradiance);
  return sun > 0.0 ? std::min<double>(sun / std::numbers::pi, std::numeric_limits<float>::max())
                   : std::numeric_limits<float>::max();
}

}  // namespace airlight
