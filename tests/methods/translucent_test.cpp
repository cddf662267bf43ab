// Translucent spheres by path-trace: in a vacuum against closed forms, in air against `orders`.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/things/bodies.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr double kBallAlbedo = 0.6;
constexpr double kMost = 7.0;  // degrees from the ball's middle; its edge is at 7.2

// A ball of a metre 8 m to the north, as high above level ground as the camera, where nothing else is; the sun to the
// east. `more`: spheres, after a comma. `spectral`: all by the wavelength, but alike at all.
struct Around {
  double strength = 3.0;
  double ground_albedo = 0.0;
  bool spectral = false;
  double altitude_m = 200.0;
  int samples = 32;
  int max_orders = 0;
  std::string more = {};
};

Scene ball_in_vacuum(const Around& around) {
  const auto value = [&](const std::string& number) {
    return around.spectral ? R"({"wavelengths_nm": [400, 700], "values": [)" + number + ", " + number + "]}" : number;
  };
  const std::string air = R"({"name": "none", "scattering_per_km": )" + value("0") +
                          R"(, "density": {"profile": "exponential", "scale_height_km": 8},
                             "phase": {"function": "rayleigh"}})";
  const std::string ball = R"({"distance_m": 8, "radius_m": 1, "material": "translucent", "albedo": )" +
                           value(std::to_string(kBallAlbedo)) + "}";
  const std::string render =
      R"({"method": "path-trace")" + std::string(around.spectral ? R"(, "wavelengths": 6})" : "}");
  Scene scene =
      scene_of(R"({"airlight": 1, "media": [)" + air + R"(], "planet": {"radius_km": 1e6, "ground_albedo": )" +
               value(std::to_string(around.ground_albedo)) +
               R"(}, "sun": {"elevation_deg": 25, "azimuth_deg": 90}, "camera": {"altitude_km": 1}, "render": )" +
               render + R"(, "scene": {"spheres": [)" + ball + around.more + "]}}");
  scene.camera.altitude = 1e-3 * around.altitude_m;
  scene.spheres[0].scatter_strength = around.strength;
  scene.render.parameters.insert_or_assign("samples", around.samples);
  scene.render.parameters.insert_or_assign("max_orders", around.max_orders);
  return scene;
}

// Directions that meet the ball, as close together everywhere.
std::vector<Direction> over_the_ball(int side) {
  std::vector<Direction> all;
  for (int i = 0; i < side * side; ++i) {
    const double x = kMost * (2.0 * (i % side + 0.5) / side - 1.0);
    const double y = kMost * (2.0 * (std::floor(1.0 * i / side) + 0.5) / side - 1.0);
    if (std::hypot(x, y) < kMost) {
      all.push_back({y * kDegree, x * kDegree});
    }
  }
  return all;
}

// What the ball sends back along a ray, for a sun of irradiance 1: 0.3 as a matte one and 0.7 of its term by thickness
// for the mean light from all around, to which the sun brings a quarter. Level ground without an end shines on the
// lower half of all directions.
double radiance_of_ball(const Scene& scene, const vec3& from, const vec3& view, double ground_albedo) {
  Physics p = make_physics(scene);
  p.spheres = spheres_of(scene);
  const vec3 normal = p.body_normal(0, from + view * p.nearest_body(from, view, 1).distance_);
  const double share =
      p.subsurface_share(p.subsurface_thickness(-dot(normal, view)), scene.spheres[0].scatter_strength);
  const vec3 sun = p.scene.sun.direction;
  const double ground = ground_albedo * sun.y / std::numbers::pi;
  const double matte = std::max(dot(normal, sun), 0.0) + std::numbers::pi * ground * 0.5 * (1.0 - normal.y);
  const double mean = 0.25 + 0.25 * 2.0 * std::numbers::pi * ground;
  return kBallAlbedo / std::numbers::pi * (0.3 * matte + 0.7 * share * mean);
}

double radiance_of_ball(const Scene& scene, const Direction& direction, double ground_albedo) {
  const vec3 view = make_physics(scene).direction_from_angles(direction.elevation, direction.azimuth);
  return radiance_of_ball(scene, vec3(0.0), view, ground_albedo);
}

// Over black ground the sun's light is all there is, and no sample is needed.
TEST(Translucent, SunlightIsTheClosedForm) {
  for (const bool spectral : {false, true}) {
    for (const double strength : {3.0, 16.0}) {
      const Scene scene = ball_in_vacuum({.strength = strength, .spectral = spectral});
      const std::vector<Direction> directions = over_the_ball(6);
      const HostPicture picture = airlight::traced(scene, View{directions});
      for (std::size_t k = 0; k < directions.size(); ++k) {
        const double want = radiance_of_ball(scene, directions[k], 0.0);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(static_cast<double>(picture.radiance.at(static_cast<int>(k), 0)[c]), want, 1e-5 * want)
              << spectral << ", " << strength << ", " << k;
          EXPECT_EQ(picture.standard_error.at(static_cast<int>(k), 0)[c], 0.0F);
        }
      }
    }
  }
}

// The ball does not hide the sun from its own far side; another one does.
TEST(Translucent, OtherSpheresHideTheSun) {
  const Scene scene = ball_in_vacuum({.more = R"(, {"distance_m": 26.2, "radius_m": 5, "material": "matte", "albedo": 0,
                                                  "azimuth_deg": 70.6, "elevation_deg": 23.7})"});
  const HostPicture picture = airlight::traced(scene, View{over_the_ball(4)});
  for (int k = 0; k < picture.radiance.width; ++k) {
    EXPECT_EQ(picture.radiance.at(k, 0)[1], 0.0F) << k;
  }
}

// Light of the second order, from bright ground: also through the ball, on whose upper side it shines by the mean term
// alone. The ball's shadow there is a ten-thousandth of it.
TEST(Translucent, LightFromBelowComesThroughTheBall) {
  constexpr double kGround = 0.8;
  for (const bool spectral : {false, true}) {
    const Scene scene = ball_in_vacuum({.ground_albedo = kGround, .spectral = spectral, .samples = 2048});
    const std::vector<Direction> directions = over_the_ball(6);
    const HostPicture picture = airlight::traced(scene, View{directions});
    double seen = 0.0;
    double wanted = 0.0;
    double variance = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double sunlight = radiance_of_ball(scene, directions[k], 0.0);
      const double want = radiance_of_ball(scene, directions[k], kGround) - sunlight;
      const double found = static_cast<double>(picture.radiance.at(static_cast<int>(k), 0)[1]) - sunlight;
      const double noise = static_cast<double>(picture.standard_error.at(static_cast<int>(k), 0)[1]);
      EXPECT_NEAR(found, want, 4.5 * noise + 0.002 * want) << spectral << ", " << k;
      seen += found;
      wanted += want;
      variance += noise * noise;
    }
    std::printf("spectral %d: %.4f of the closed form, noise %.4f\n", spectral, seen / wanted,
                std::sqrt(variance) / wanted);
    EXPECT_NEAR(seen, wanted, 0.004 * wanted);
  }
}

// Sunlight that the ball sends to the ground below it, where sun and ball both shine.
TEST(Translucent, LightsTheGround) {
  constexpr double kGround = 0.8;
  constexpr double kHeight = 2e-3;
  for (const bool spectral : {false, true}) {
    const Scene scene = ball_in_vacuum({.ground_albedo = kGround,
                                        .spectral = spectral,
                                        .altitude_m = 1e3 * kHeight,
                                        .samples = 32768,
                                        .max_orders = 2});
    const vec3 below(0.0, -kHeight, -8e-3);
    const double widest = std::asin(1e-3 / kHeight);
    double irradiance = 0.0;
    constexpr int kRows = 40;
    constexpr int kColumns = 40;
    for (int k = 0; k < kRows * kColumns; ++k) {
      const double tilt = widest * (std::floor(1.0 * k / kColumns) + 0.5) / kRows;
      const double turn = 2.0 * std::numbers::pi * (k % kColumns + 0.5) / kColumns;
      const vec3 up(std::sin(tilt) * std::cos(turn), std::cos(tilt), std::sin(tilt) * std::sin(turn));
      const double angle = std::sin(tilt) * (widest / kRows) * 2.0 * std::numbers::pi / kColumns;
      irradiance += radiance_of_ball(scene, below, up, 0.0) * up.y * angle;
    }
    const std::vector<Direction> directions{{std::atan2(below.y, -below.z), 0.0}};
    const HostPicture picture = airlight::traced(scene, View{directions});
    const double sunlight = std::sin(scene.sun.elevation);
    const double found = static_cast<double>(picture.radiance.at(0, 0)[1]) * std::numbers::pi / kGround - sunlight;
    const double noise = static_cast<double>(picture.standard_error.at(0, 0)[1]) * std::numbers::pi / kGround;
    std::printf("spectral %d: %.4f of the closed form, noise %.4f\n", spectral, found / irradiance, noise / irradiance);
    EXPECT_NEAR(found, irradiance, 3.0 * noise);
    EXPECT_LT(noise, 0.02 * irradiance);
  }
}

// In clear air over white ground, high enough that the ball's own shadow is small.
TEST(Translucent, OrdersIsNearPathTrace) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.planet.ground_albedo = {0.8, 0.8, 0.8};
  scene.sun.elevation = 25.0 * kDegree;
  scene.sun.azimuth = 90.0 * kDegree;
  scene.sun.disc.visible = false;
  scene.camera.altitude = 0.03;
  scene.spheres = ball_in_vacuum({}).spheres;
  const std::vector<Direction> directions = over_the_ball(5);
  const std::vector<ProbeResult> found = probe_now(scene, directions);
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters.insert_or_assign("samples", 256);
  const HostPicture truth = airlight::traced(traced, View{directions});
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    double truths = 0.0;
    double variance = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      sum += found[k].radiance[c];
      truths += static_cast<double>(truth.radiance.at(static_cast<int>(k), 0)[c]);
      const double noise = static_cast<double>(truth.standard_error.at(static_cast<int>(k), 0)[c]);
      variance += noise * noise;
    }
    std::printf("channel %zu: orders over path-trace %.4f, noise %.4f\n", c, sum / truths,
                std::sqrt(variance) / truths);
    EXPECT_NEAR(sum, truths, 0.015 * truths) << c;
  }
}

}  // namespace
}  // namespace airlight::test
