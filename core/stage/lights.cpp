#include "core/stage/lights.h"

#include <cmath>

namespace airlight {

Scene by_moonlight(const Scene& scene) {
  const Moon& moon = *scene.moon;
  Scene lit = scene;
  lit.moon.reset();
  lit.night_sky.reset();
  lit.stars.reset();
  lit.sun = {.elevation = moon.elevation,
             .azimuth = moon.azimuth,
             .irradiance = moon.irradiance,
             .unit = scene.sun.unit,
             .disc = {.visible = scene.sun.disc.visible,
                      .angular_radius = std::asin(kMoonRadius / moon.distance),
                      .limb_darkening = 0.0,
                      .radiance_scale = 1.0,
                      .lit = moon.lit}};
  if (lit.spectra) {
    lit.spectra->light = moon.over_sun;
  }
  return lit;
}

}  // namespace airlight
