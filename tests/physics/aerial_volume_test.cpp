// Places of the aerial volume's slices, and the number of steps of a cut ray.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

constexpr int kAerialSlices = 16;

struct Start {
  double h;
  double mu;
};

// Up, level, dipping before it rises, to the ground; from the ground to the top of the air.
std::vector<Start> aerial_starts(Physics& p) {
  std::vector<Start> all;
  for (const double h : {0.001, 0.1, 2.0, 20.0, 99.0}) {
    const double horizon = p.horizon_mu(p.scene.planet, h);
    for (const double mu : {1.0, 0.3, 0.0, 0.5 * horizon, horizon, 1.0001 * horizon - 1e-6, -0.5, -1.0}) {
      all.push_back({h, mu});
    }
  }
  return all;
}

TEST(AerialVolume, SlicesRiseFromTheCameraToTheEndAndMapBack) {
  Physics p = make_physics(earth());
  const auto& planet = p.scene.planet;
  for (const Start& start : aerial_starts(p)) {
    const Physics::Ray ray = p.ray_in_atmosphere(planet, start.h, start.mu, 0.3, 0.1);
    EXPECT_NEAR(p.slice_distance(planet, ray, 0.0), 0.0, 1e-9 * ray.length_);
    EXPECT_NEAR(p.slice_distance(planet, ray, 1.0), ray.length_, 1e-9 * ray.length_);
    double before = -1.0;
    for (int i = 0; i < kAerialSlices; ++i) {
      const double z = static_cast<double>(i) / (kAerialSlices - 1);
      const double distance = p.slice_distance(planet, ray, z);
      EXPECT_GT(distance, before) << start.h << " km, " << start.mu;
      EXPECT_NEAR(p.slice_coordinate(planet, ray, distance), z, 1e-6) << start.h << " km, " << start.mu;
      before = distance;
    }
  }
}

TEST(AerialVolume, StepsOfACutRayAreAsDenseAsTheWholeOnes) {
  Physics p = make_physics(earth());
  const auto& planet = p.scene.planet;
  for (const Start& start : aerial_starts(p)) {
    const Physics::Ray ray = p.ray_in_atmosphere(planet, start.h, start.mu, 0.3, 0.1);
    if (!ray.at_ground) {
      EXPECT_EQ(p.steps_up_to(planet, ray, ray.length_, 2, 48), 48U) << start.h << " km, " << start.mu;
    }
    physics::uint before = 0;
    for (const double part : {0.0, 1e-4, 0.01, 0.3, 1.0}) {
      const physics::uint steps = p.steps_up_to(planet, ray, part * ray.length_, 4, 48);
      EXPECT_GE(steps, std::max(before, 4U));
      EXPECT_LE(steps, 48U);
      before = steps;
    }
  }
  // Straight down through all the air takes as many steps as straight up.
  const Physics::Ray down = p.ray_in_atmosphere(planet, planet.atmosphere_height, -1.0, 0.3, 0.1);
  EXPECT_EQ(p.steps_up_to(planet, down, down.length_, 2, 48), 48U);
  const Physics::Ray up = p.ray_in_atmosphere(planet, 0.0, 1.0, 0.3, 0.1);
  EXPECT_EQ(p.steps_up_to(planet, up, 0.25 * up.length_, 2, 48), 24U);
}

// 1 - exp(-x), relative to x, as accurate as the series of mean_transmittance().
TEST(AerialVolume, TheShareTakenOutOfLight) {
  Physics p;
  for (const double x : {0.0, 1e-12, 1e-3, 0.4, 0.6, 5.0}) {
    EXPECT_NEAR(p.gathered_share({x, x, x}).y, -std::expm1(-x), 3e-9 * x);
  }
}

// Successive parts lie where the whole ray is.
TEST(AerialVolume, APartOfARayRunsAlongIt) {
  Physics p = make_physics(earth());
  const auto& planet = p.scene.planet;
  for (const Start& start : aerial_starts(p)) {
    const Physics::Ray ray = p.ray_in_atmosphere(planet, start.h, start.mu, 0.3, 0.1);
    const Physics::Ray part = p.part_of_ray(planet, ray, 0.4 * ray.length_, 0.9 * ray.length_);
    const Physics::RayPoint there = p.point_on_ray(planet, part, part.length_);
    const Physics::RayPoint here = p.point_on_ray(planet, ray, 0.9 * ray.length_);
    EXPECT_NEAR(there.h, here.h, 1e-7);
    EXPECT_NEAR(there.mu, here.mu, 1e-9);
    EXPECT_NEAR(there.mu_sun, here.mu_sun, 1e-9);
  }
}

}  // namespace
}  // namespace airlight::test
