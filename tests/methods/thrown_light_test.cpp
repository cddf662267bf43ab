// Sunlight that mirror spheres throw on the ground by path-trace, in a vacuum against beams that are followed one by
// one.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/methods/cloud_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr double kMirrorAlbedo = 0.6;
constexpr double kLevelAlbedo = 0.8;
constexpr double kEyeHeight = 2.0;    // m, of camera and ball
constexpr double kMirrorAhead = 8.0;  // m

// A mirror of a metre 8 m to the north, as high above level ground as the camera; the sun to the east. `more`: spheres,
// after a comma. `spectral`: all by the wavelength, but alike at all.
Scene mirror_in_vacuum(bool spectral, const std::string& more = {}) {
  const auto value = [&](double number) {
    const std::string text = std::to_string(number);
    return spectral ? R"({"wavelengths_nm": [400, 700], "values": [)" + text + ", " + text + "]}" : text;
  };
  Scene scene =
      scene_of(R"({"airlight": 1, "media": [{"name": "none", "scattering_per_km": )" + value(0.0) +
               R"(, "density": {"profile": "exponential", "scale_height_km": 8},
                             "phase": {"function": "rayleigh"}}], "planet": {"radius_km": 1e6, "ground_albedo": )" +
               value(kLevelAlbedo) +
               R"(}, "sun": {"elevation_deg": 35, "azimuth_deg": 90}, "camera": {"altitude_km": 1},
                             "render": {"method": "path-trace")" +
               (spectral ? R"(, "wavelengths": 6)" : "") +
               R"(}, "scene": {"spheres": [{"distance_m": 8, "radius_m": 1, "material": "mirror", "albedo": )" +
               value(kMirrorAlbedo) + "}" + more + "]}}");
  scene.camera.altitude = 1e-3 * kEyeHeight;
  scene.render.parameters.insert_or_assign("samples", 1);
  scene.render.parameters.insert_or_assign("max_orders", 2);
  return scene;
}

// Irradiance of level ground within `radius` of (east, north), m, over that of the beam before the mirror of albedo 1.
double thrown_by_beams(const vec3& sun, double east, double north, double radius) {
  constexpr int kSide = 2000;
  const vec3 aside = physics::normalize(vec3(-sun.z, 0.0, sun.x));
  const vec3 over = physics::cross(sun, aside);
  const double each = 4.0 / (kSide * kSide);  // m2 of the beam
  double sum = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double x = 2.0 * (i % kSide + 0.5) / kSide - 1.0;
    const double y = 2.0 * (std::floor(1.0 * i / kSide) + 0.5) / kSide - 1.0;
    const double square = x * x + y * y;
    if (square >= 1.0) {
      continue;
    }
    const vec3 normal = aside * x + over * y + sun * std::sqrt(1.0 - square);
    const vec3 turned = normal * (2.0 * physics::dot(sun, normal)) - sun;
    const double way = -(kEyeHeight + normal.y) / turned.y;
    const double off_east = normal.x + turned.x * way - east;
    const double off_north = kMirrorAhead - normal.z - turned.z * way - north;
    sum += turned.y < 0.0 && std::hypot(off_east, off_north) < radius ? each : 0.0;
  }
  return sum / (std::numbers::pi * radius * radius);
}

// Seen by the camera at such a place of the ground, over what a matte ground sends of a beam that meets it straight.
double ground_at(const Scene& scene, double east, double north) {
  const std::vector<Direction> directions{{std::atan2(-kEyeHeight, std::hypot(east, north)), std::atan2(east, north)}};
  const HostPicture picture = airlight::traced(scene, View{directions});
  return static_cast<double>(picture.radiance.at(0, 0)[1]) * std::numbers::pi / kLevelAlbedo;
}

TEST(ThrownLight, IsThatOfItsBeams) {
  const Scene colours = mirror_in_vacuum(false);
  const Scene wavelengths = mirror_in_vacuum(true);
  const double direct = std::sin(colours.sun.elevation);
  const vec3 sun = make_physics(colours).scene.sun.direction;
  for (const auto& [east, north] : {std::pair(1.0, 6.0), {2.0, 8.5}, {0.5, 9.5}, {4.0, 5.0}}) {
    const double want = kMirrorAlbedo * thrown_by_beams(sun, east, north, 0.15);
    EXPECT_GT(want, 0.002);
    EXPECT_NEAR(ground_at(colours, east, north) - direct, want, 0.03 * want) << east;
    EXPECT_NEAR(ground_at(wavelengths, east, north) - direct, want, 0.03 * want) << east;
  }
}

TEST(ThrownLight, OtherSpheresHideIt) {
  for (const bool spectral : {false, true}) {
    // Between the mirror and the place, and between the mirror and the sun; neither shades the place itself.
    for (const char* more : {R"(, {"distance_m": 8.518, "radius_m": 0.2, "material": "matte", "albedo": 0,
                                   "azimuth_deg": 10.12, "elevation_deg": -7.44})",
                             R"(, {"distance_m": 22.23, "radius_m": 1.5, "material": "matte", "albedo": 0,
                                   "azimuth_deg": 64.9, "elevation_deg": 30.45})"}) {
      const Scene scene = mirror_in_vacuum(spectral, more);
      const double lit = ground_at(mirror_in_vacuum(spectral), 2.0, 8.5);
      const double hidden = ground_at(scene, 2.0, 8.5);
      EXPECT_NEAR(hidden, std::sin(scene.sun.elevation), 1e-5) << more;
      EXPECT_GT(lit, hidden + 0.005);
    }
  }
}

// A black level cloud far above takes of it what it takes of all sunlight. A black ball keeps the sun's own beam from
// the place.
TEST(ThrownLight, PassesClouds) {
  constexpr double kDepth = 0.5;
  for (const bool spectral : {false, true}) {
    Scene scene = mirror_in_vacuum(spectral, R"(, {"distance_m": 13.79, "radius_m": 0.6, "material": "matte",
                                                   "albedo": 0, "azimuth_deg": 50.16, "elevation_deg": 15.72})");
    const double clear = ground_at(scene, 2.0, 8.5);
    EXPECT_NEAR(clear, ground_at(mirror_in_vacuum(spectral), 2.0, 8.5) - std::sin(scene.sun.elevation), 1e-5);
    scene.planet.atmosphere_height = 20.0;
    scene.clouds = under_level_cloud(kDepth, 0.5).clouds;
    scene.clouds.front().single_scattering_albedo = 0.0;
    scene.render.parameters.insert_or_assign("samples", 8192);
    const double left = clear * std::exp(-kDepth / std::sin(scene.sun.elevation));
    EXPECT_NEAR(ground_at(scene, 2.0, 8.5), left, 0.06 * left) << spectral;
  }
}

}  // namespace
}  // namespace airlight::test
