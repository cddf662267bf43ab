// The view march against brute force in Cartesian coordinates, and changes that must not affect it.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/brute_force.h"
#include "tests/physics/host_tables.h"
#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr unsigned int kQuadratic = physics::kStepsQuadratic;

Physics::PathRadiance march_along(Physics& p, double h, const vec3& direction, unsigned int steps,
                                  double scattering_scale = 1.0, unsigned int distribution = kQuadratic) {
  const vec3 sun = p.scene.sun.direction;
  const auto ray = p.ray_in_atmosphere(p.scene.planet, h, direction.y, sun.y, physics::dot(direction, sun));
  return p.march(p.scene.planet, p.scene.sun, ray, steps, distribution, scattering_scale);
}

vec3 towards(double elevation_deg, double azimuth_deg) {
  Physics p{};
  return p.direction_from_angles(elevation_deg * kDegree, azimuth_deg * kDegree);
}

Physics baked(const Scene& scene, const HostTableSizes& sizes = {}) {
  Physics p = make_physics(scene);
  bake(p, sizes);
  return p;
}

struct View {
  double sun_elevation;
  double altitude;
  double elevation;
  double azimuth;
  double tolerance;  // 512 steps on a fine table against brute force
};

TEST(March, AgreesWithBruteForceSingleScattering) {
  const View views[] = {{60.0, 0.001, 45.0, 30.0, 0.003},  {20.0, 0.001, 2.0, 90.0, 0.003},
                        {20.0, 0.001, 20.5, 0.0, 0.003},   {0.5, 0.001, 5.0, 10.0, 0.005},
                        {0.5, 0.5, 0.2, 180.0, 0.005},     {-2.0, 0.001, 10.0, 0.0, 0.01},
                        {-4.0, 0.001, 3.0, 20.0, 0.01},    {20.0, 10.0, -2.0, 45.0, 0.005},
                        {20.0, 35.0, -30.0, 100.0, 0.005}, {5.0, 99.9, -8.0, 10.0, 0.005}};
  Scene scene = earth();
  Physics p = baked(scene, {512, 256, 2, 64});
  for (const View& view : views) {
    p.scene.sun.direction = towards(view.sun_elevation, 0.0);
    const vec3 direction = towards(view.elevation, view.azimuth);
    const vec3 found = march_along(p, view.altitude, direction, 512, 0.0).radiance;
    const vec3 expected = BruteForce(p).radiance(view.altitude, direction, 3000, 300);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(channel(found, c) / channel(expected, c), 1.0, view.tolerance)
          << "sun " << view.sun_elevation << ", from " << view.altitude << " km to " << view.elevation << ", channel "
          << c;
    }
  }
}

// Published code at 2048 steps is worse than at 64. Here the error against 65536 steps never grows, except by rounding.
TEST(March, MoreStepsAreNeverWorse) {
  Physics p = baked(earth(), {256, 64, 8, 64});
  for (const double sun : {60.0, 5.0, -2.0}) {
    p.scene.sun.direction = towards(sun, 0.0);
    for (const double h : {0.001, 99.9}) {
      for (const double elevation : {1.0, 30.0, -9.0}) {
        const vec3 direction = towards(elevation, 40.0);
        const vec3 reference = march_along(p, h, direction, 65536).radiance;
        double before = 1.0;
        for (unsigned int steps = 32; steps <= 4096; steps *= 4) {
          const double error = std::abs(march_along(p, h, direction, steps).radiance.z / reference.z - 1.0);
          // Half as large with four times the steps, or below 2e-4, as the shadow's edge may fall anywhere in a step.
          EXPECT_LE(error, std::max(0.5 * before, 2e-4)) << sun << ", " << h << ", " << elevation << ": " << steps;
          before = std::max(error, 1e-12);
        }
      }
    }
  }
}

TEST(March, TransmittanceIsThatOfThePath) {
  Physics p = baked(every_kind(), {64, 32, 4, 16});
  for (const double elevation : {90.0, 20.0, 1.0}) {
    const auto path = march_along(p, 0.5, towards(elevation, 10.0), 4096);
    const vec3 depth = p.optical_depth_to_top(p.scene.planet, 0.5, std::sin(elevation * kDegree), 4096);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(channel(path.transmittance, c), std::exp(-channel(depth, c)), 1e-9) << elevation;
    }
  }
}

// The light is in proportion to the air, down to nothing, and nothing at all in a vacuum.
TEST(March, GoesBlackAsTheMediumVanishes) {
  double before = 0.0;
  for (const double share : {1e-3, 1e-6, 1e-12, 1e-30, 1e-300}) {
    Scene scene = earth();
    for (Medium& m : scene.media) {
      for (std::size_t c = 0; c < 3; ++c) {
        m.scattering[c] *= share;
        m.absorption[c] *= share;
      }
    }
    Physics p = baked(scene, {32, 8, 4, 16});
    const double radiance = march_along(p, 0.001, towards(20.0, 50.0), 32).radiance.z;
    if (before > 0.0) {
      EXPECT_NEAR(radiance / share / before, 1.0, 1e-3) << share;
    }
    before = radiance / share;
  }
  Physics empty = baked(vacuum(), {32, 8, 4, 16});
  const auto path = march_along(empty, 0.001, towards(20.0, 50.0), 32);
  EXPECT_EQ(path.radiance.z, 0.0);
  EXPECT_EQ(path.transmittance.z, 1.0);
}

TEST(March, IsMirrorSymmetricAboutTheSun) {
  Scene scene = every_kind();
  scene.sun.azimuth = 75.0 * kDegree;
  for (const double sun : {40.0, 0.0, -3.0}) {
    scene.sun.elevation = sun * kDegree;
    Physics p = baked(scene, {64, 16, 8, 16});
    for (const double elevation : {-20.0, -0.5, 0.5, 10.0, 80.0}) {
      for (const double aside : {0.1, 5.0, 60.0, 179.0}) {
        const vec3 left = march_along(p, 1.0, towards(elevation, 75.0 - aside), 32).radiance;
        const vec3 right = march_along(p, 1.0, towards(elevation, 75.0 + aside), 32).radiance;
        EXPECT_NEAR(left.x, right.x, 1e-12 * right.x) << sun << ", " << elevation << ", " << aside;
        EXPECT_NEAR(left.z, right.z, 1e-12 * right.z) << sun << ", " << elevation << ", " << aside;
      }
    }
  }
}

TEST(March, IsInProportionToTheIrradiance) {
  Physics p = baked(every_kind(), {64, 16, 8, 16});
  const vec3 unit = march_along(p, 1.0, towards(-20.0, 10.0), 32).radiance;
  p.scene.sun.irradiance = vec3(2.0, 30.0, 0.0);
  const vec3 scaled = march_along(p, 1.0, towards(-20.0, 10.0), 32).radiance;
  EXPECT_NEAR(scaled.x, 2.0 * unit.x, 1e-15);
  EXPECT_NEAR(scaled.y, 30.0 * unit.y, 1e-14);
  EXPECT_EQ(scaled.z, 0.0);
}

TEST(March, SeesNothingWhereThereIsNoAir) {
  Physics p = baked(every_kind(), {64, 16, 8, 16});
  for (const double elevation : {-10.0, 0.0, 45.0, 90.0}) {
    const auto path = march_along(p, 500.0, towards(elevation, 10.0), 32);
    EXPECT_EQ(path.radiance.x, 0.0) << elevation;
    EXPECT_EQ(path.transmittance.x, 1.0) << elevation;
  }
  // Exactly at the top and looking up.
  EXPECT_EQ(march_along(p, 100.0, towards(30.0, 10.0), 32).radiance.x, 0.0);
  // From the ground at any downward angle: the ground itself, with no air between.
  const vec3 ground = march_along(p, 0.0, towards(-50.0, 10.0), 32).radiance;
  EXPECT_NEAR(ground.x, p.ground_radiance(p.scene.planet, p.scene.sun, p.scene.sun.direction.y).x, 1e-15);
}

}  // namespace
}  // namespace airlight::test
