// Ground by maps and the sea in air that bends light: where rays meet them, against exact rays, and pictures against
// path-trace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "tests/methods/bent_scene.h"
#include "tests/methods/ground_scene.h"

namespace airlight::test {
namespace {

using physics::vec3;

// Where an exact ray meets the ground.
ExactPoint exact_ground(double h, double zenith) {
  const ExactAir air;
  ExactPoint p{h, 0.0, zenith, 0.0, 0.0, 0.0};
  const double step = 0.02 * h / std::abs(std::cos(zenith));
  ExactPoint next = exact_step(air, p, step);
  while (next.h > 0.0 && next.h < p.h) {
    p = next;
    next = exact_step(air, p, step);
  }
  const double part = p.h / std::max(p.h - next.h, 1e-12);
  return exact_step(air, p, step * part);
}

// Distance along the ground to where a straight ray meets it, or comes nearest.
double straight_ground(double radius, double h, double zenith) {
  const double angle = std::asin(std::min((radius + h) / radius * std::sin(zenith), 1.0));
  return radius * (zenith - 0.5 * std::numbers::pi - (0.5 * std::numbers::pi - angle));
}

// Distance along the ground, and the angle to it, at which a seen direction meets the ground.
TEST(BentGround, RaysMeetItWhereExactRaysDo) {
  struct Case {
    double camera;
    double most;  // relative error of the distance
  };
  for (const Case& c : {Case{0.03, 1e-3}, Case{0.1, 1e-3}, Case{2.0, 0.01}, Case{10.0, 0.03}}) {
    const double horizon = exact_horizon(ExactAir{}, c.camera);
    for (const double below_deg : {0.02, 0.1, 0.5, 3.0}) {
      Scene scene = clear_and_bent("orders", c.camera);
      scene.ground.emplace().ocean.emplace();
      physics::Physics p = geometry_of(part_of(scene).scene);
      const physics::PlanetData& planet = p.scene.planet;
      const double zenith = horizon + below_deg * kDegree;
      const vec3 direction(std::sin(zenith), std::cos(zenith), 0.0);
      const auto place = p.ground_place(planet, p.scene.camera.altitude, direction);
      ASSERT_TRUE(place.hit);
      const vec3 up = p.true_vertical(planet, place.up);
      const ExactPoint exact = exact_ground(c.camera, zenith);
      const double round = std::atan2(up.x, up.y);
      const double steep = std::asin(place.cosine);
      const double exact_steep = exact.zenith - 0.5 * std::numbers::pi;
      const double ground = scene.planet.ground_radius * exact.round;
      const double straight = straight_ground(scene.planet.ground_radius, c.camera, zenith);
      std::printf(
          "camera %g km, %g degrees under the horizon: %.3f km off %.2f, straight rays %.2f; angle %.4f for %.4f\n",
          c.camera, below_deg, scene.planet.ground_radius * round - ground, ground, straight - ground, steep / kDegree,
          exact_steep / kDegree);
      EXPECT_NEAR(round, exact.round, c.most * exact.round) << c.camera << ", " << below_deg;
      EXPECT_NEAR(steep, exact_steep, 1e-3 * exact_steep) << c.camera << ", " << below_deg;
      EXPECT_NEAR(place.distance_, exact.length, c.most * exact.length) << c.camera << ", " << below_deg;
    }
  }
}

// Stripes of 300 km from north to south, seen from 10 km toward the east, where the horizon is 400 km away.
TEST(BentGround, AMapLiesWherePathTraceSeesIt) {
  constexpr int kRows = 512;
  Scene scene = clear_and_bent("orders", 10.0);
  put_map(scene, "stripes", kRows, [](int i, int) {
    const double wave = std::sin(i * (std::numbers::pi / kRows) * 6371.0 * 2.0 * std::numbers::pi / 300.0);
    return Spectrum{0.4 + 0.35 * wave, 0.4 + 0.35 * wave, 0.4 + 0.35 * wave};
  });
  scene.planet.ground_albedo = {0.4, 0.4, 0.4};
  scene.sun.elevation = 40.0 * kDegree;
  std::vector<Direction> directions;
  const double horizon = exact_horizon(ExactAir{}, 10.0) - 0.5 * std::numbers::pi;
  for (int k = 0; k < 16; ++k) {
    directions.push_back({-horizon - (0.02 + 0.05 * k) * kDegree, (80.0 + 20.0 * (k % 2)) * kDegree});
  }
  const HostPicture truth = truth_of(scene, directions, 128);
  Scene straight = scene;
  straight.planet.refraction.reset();
  const HostPicture straight_truth = truth_of(straight, directions, 128);
  for (const char* method : {"orders", "march"}) {
    Scene by = with_method(scene, *find_method(method));
    Scene straight_by = with_method(straight, *find_method(method));
    by.render.polarisation = straight_by.render.polarisation = false;
    const double in_bent = mean_error(by, truth, directions);
    const double in_straight = mean_error(straight_by, straight_truth, directions);
    const double by_straight = mean_error(straight_by, truth, directions);
    std::printf("%s: %.4f, in straight air %.4f, by straight rays %.4f\n", method, in_bent, in_straight, by_straight);
    EXPECT_LT(in_bent, in_straight + 0.015) << method;
    EXPECT_GT(by_straight, 4.0 * in_bent) << method;
  }
}

// The sun in waves, from a cliff: toward a sun that is low or, by straight rays, has set.
TEST(BentGround, TheSeaGlintsAsPathTracesDoes) {
  for (const double camera : {0.03, 1.0}) {
    for (const double sun : {3.0, 0.3, -0.3}) {
      Scene scene = clear_and_bent("orders", camera);
      scene.ground.emplace().ocean.emplace();
      scene.planet.ground_albedo = {0.02, 0.02, 0.02};
      scene.sun.elevation = sun * kDegree;
      scene.sun.azimuth = 90.0 * kDegree;
      std::vector<Direction> directions;
      const double horizon = exact_horizon(ExactAir{}, camera) - 0.5 * std::numbers::pi;
      for (const double below : {0.03, 0.1, 0.3, 1.0, 3.0}) {
        directions.push_back({-horizon - below * kDegree, 90.0 * kDegree});
        directions.push_back({-horizon - below * kDegree, 94.0 * kDegree});
      }
      const HostPicture truth = truth_of(scene, directions, 256);
      for (const char* method : {"orders", "march"}) {
        Scene by = with_method(scene, *find_method(method));
        by.render.polarisation = false;
        const double error = mean_error(by, truth, directions);
        std::printf("%s, camera %g km, sun %g: %.4f\n", method, camera, sun, error);
        EXPECT_LT(error, 0.03) << method << ", " << camera << ", " << sun;
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
