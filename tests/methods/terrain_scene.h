#pragma once
// A mountain range in haze, for the tests of terrain.

#include "tests/methods/render_fixture.h"

namespace airlight::test {

// The range stands 22 km to the east, the sun behind or over it.
inline Scene range_in_haze(const char* method, double sun_elevation_deg) {
  Scene scene = with_method(earth(), *find_method(method));
  scene.media[1].scattering = {0.03, 0.03, 0.03};
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.sun.elevation = sun_elevation_deg * kDegree;
  scene.sun.azimuth = 90.0 * kDegree;
  scene.camera.altitude = 0.1;
  Terrain terrain;
  terrain.ridge = Ridge{7, 2.6};
  terrain.width = 60.0;
  terrain.bearing = 90.0 * kDegree;
  terrain.distance = 22.0;
  terrain.turn = 90.0 * kDegree;
  terrain.albedo = {0.4, 0.3, 0.2};
  scene.terrain = terrain;
  return scene;
}

}  // namespace airlight::test
