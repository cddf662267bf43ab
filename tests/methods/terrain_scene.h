#pragma once
// A mountain range in haze, for the tests of terrain.

#include <cmath>
#include <optional>

#include "core/physics/physics.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {

// A place in the air about the range: over the map, km from the camera, and its vertical.
struct RangePlace {
  physics::vec3 up;
  double h = 0.0;
  double east = 0.0;
  double north = 0.0;
};

// By three numbers from 0 to 1; none where the slopes are less than 20 m below. `p` has the terrain's maps.
inline std::optional<RangePlace> place_in_range(physics::Physics& p, double radius, double a, double b, double c) {
  const double s = 50.0 * a;
  const double azimuth = (60.0 + 60.0 * b) * kDegree;
  const double angle = s / radius;
  const RangePlace place{{std::sin(azimuth) * std::sin(angle), std::cos(angle), -std::cos(azimuth) * std::sin(angle)},
                         2.7 * c,
                         s * std::sin(azimuth),
                         s * std::cos(azimuth)};
  const auto shape = p.terrain_shape();
  const double ground =
      p.map_height(shape, p.map_column(shape, place.east, place.north), p.map_row(shape, place.east, place.north));
  return place.h < ground + 0.02 ? std::nullopt : std::optional(place);
}

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
