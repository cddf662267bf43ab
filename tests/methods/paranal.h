#pragma once
// The built-in air over Paranal.

#include "core/methods/method.h"
#include "core/scene/photometry.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/physics/scenes.h"

namespace airlight::test {

// 2.635 km above the sea, on a night with the galaxy's plane low.
inline Scene paranal(double sun_elevation_deg) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/earth.json"), method_infos());
  scene.sun.elevation = sun_elevation_deg * kDegree;
  scene.sun.unit = SunUnit::lux;
  scene.spectra->irradiance = kSunlight;
  scene.sun.irradiance.fill(kSunlight);
  scene.camera.altitude = 2.635;
  scene.camera.latitude = -24.6 * kDegree;
  scene.camera.longitude = -70.4 * kDegree;
  scene.camera.julian_date = 2452000.6;
  scene.night_sky = NightSky{};
  return scene;
}

}  // namespace airlight::test
