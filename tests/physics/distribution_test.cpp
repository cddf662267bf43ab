// Every distribution of steps covers the ray once, converges to the same light, and is sound where air is thick or
// absent.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/host_tables.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr unsigned int kAll[] = {physics::kStepsUniform, physics::kStepsQuadratic, physics::kStepsGaussLegendre};

// Up, down and tangent from the ground, inside, the top and outside.
std::vector<Physics::Ray> rays_of(Physics& p) {
  std::vector<Physics::Ray> rays;
  for (const double h : {0.0, 1e-4, 1.0, 35.0, 99.99, 100.0, 600.0}) {
    const double horizon = std::asin(p.horizon_mu(p.scene.planet, h));
    for (const double mu : {1.0, 0.3, 0.0, std::sin(horizon), std::sin(horizon + 1e-7), std::sin(horizon - 1e-7),
                            std::sin(horizon + 0.02), -0.4, -1.0}) {
      for (const double sun : {0.5, 0.0, -0.05}) {
        const auto ray = p.ray_in_atmosphere(p.scene.planet, h, mu, sun, mu * sun);
        if (ray.length_ > 0.0) {
          rays.push_back(ray);
        }
      }
    }
  }
  return rays;
}

Scene fog(double optical_depth) {
  Scene scene = vacuum();
  const double s = optical_depth / 8.0;
  scene.media = {medium("fog", {s, s, 0.1 * s}, {}, exponential(8.0))};
  return scene;
}

// Twice two panels and more, split at the lowest point and at the shadow.
TEST(GaussPanels, CoverTheRay) {
  Physics p = make_physics(earth());
  for (const Physics::Ray& ray : rays_of(p)) {
    for (const unsigned int panels : {3U, 4U, 8U, 128U}) {
      const auto plan = p.plan_steps(p.scene.planet, ray, panels);
      double sum = 0.0;
      for (unsigned int i = 0; i < panels; ++i) {
        const auto panel = p.planned_step(plan, i);
        ASSERT_GE(panel.width, 0.0);
        ASSERT_NEAR(panel.t, sum + 0.5 * panel.width, 1e-9 * ray.length_) << i << " of " << panels;
        sum += panel.width;
      }
      EXPECT_NEAR(sum / ray.length_, 1.0, 1e-12) << "from " << ray.h << " along " << ray.mu;
    }
  }
}

// A scattering medium in light that is equal everywhere: the ray gains as much light as it hides, whatever the steps.
TEST(Distributions, MakeAndLoseNoLight) {
  for (const double depth : {0.0, 1e-30, 1e-6, 0.1, 1.0, 30.0, 1000.0}) {
    Physics p = make_physics(fog(depth));
    p.transmittance_lut = {1, 1, {vec3(0.0)}};
    p.multiple_scattering_lut = {1, 1, {vec3(0.7)}};
    for (const Physics::Ray& ray : rays_of(p)) {
      for (const unsigned int distribution : kAll) {
        for (const unsigned int n : {1U, 2U, 3U, 8U, 33U}) {
          const auto path = p.march(p.scene.planet, p.scene.sun, ray, n, distribution, 1.0);
          const vec3 expected = p.scene.sun.irradiance * 0.7 * (vec3(1.0) - path.transmittance);
          for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_NEAR(channel(path.radiance, c), channel(expected, c), 1e-12 * channel(p.scene.sun.irradiance, c))
                << "depth " << depth << ", rule " << distribution << ", " << n << " steps from " << ray.h << " along "
                << ray.mu;
            ASSERT_TRUE(channel(path.transmittance, c) >= 0.0 && channel(path.transmittance, c) <= 1.0);
          }
        }
      }
    }
  }
}

vec3 lit(Physics& p, double h, double elevation, unsigned int n, unsigned int distribution, double place = 0.5) {
  const vec3 view = p.direction_from_angles(elevation * kDegree, 0.7);
  const vec3 sun = p.scene.sun.direction;
  const auto ray = p.ray_in_atmosphere(p.scene.planet, h, view.y, sun.y, physics::dot(view, sun));
  return p.march_at(p.scene.planet, p.scene.sun, ray, n, distribution, place, 0.0).radiance;
}

// Sunlight by 40 steps of its own, without a table, is smooth.
Physics tableless(const Scene& scene, double sun) {
  Physics p = make_physics(scene);
  p.sun_steps = 40;
  p.multiple_scattering_lut = {1, 1, {vec3(0.0)}};
  p.scene.sun.direction = p.direction_from_angles(sun * kDegree, 0.0);
  return p;
}

struct Sight {
  double sun;
  double altitude;
  double elevation;
};
constexpr Sight kSights[] = {{60.0, 0.001, 80.0}, {60.0, 0.001, 2.0}, {5.0, 0.001, 20.0},  {-3.0, 0.001, 6.0},
                             {20.0, 10.0, -2.0},  {5.0, 99.9, -8.0},  {20.0, 400.0, -17.5}};

// No part of the ray is left out, however few the steps and wherever the planet's shadow, which a sun at -1 degrees
// already has, and the lowest point cut the ray. Lengths are so close that a cut also falls within less than a step of
// the ray's end.
TEST(Distributions, PlannedStepsCoverTheRay) {
  for (const double sun : {-1.0, -3.0, -6.0}) {
    for (const double elevation : {-3.0, -1.0, 0.5, 3.75, 30.0}) {
      for (double length = 0.5; length < 400.0; length *= 1.07) {
        Physics p = tableless(earth(), sun);
        const vec3 view = p.direction_from_angles(elevation * kDegree, 0.3);
        const vec3 toward = p.scene.sun.direction;
        auto ray = p.ray_in_atmosphere(p.scene.planet, 2.0, view.y, toward.y, physics::dot(view, toward));
        ray.length_ = std::min(ray.length_, length);
        for (unsigned int n = 1; n <= 9; ++n) {
          const auto plan = p.plan_steps(p.scene.planet, ray, n);
          double end = 0.0;
          for (unsigned int i = 0; i < n; ++i) {
            const auto step = p.planned_step(plan, i);
            EXPECT_NEAR(step.t - 0.5 * step.width, end, 1e-6 * ray.length_) << n << " steps, sun " << sun;
            end = step.t + 0.5 * step.width;
          }
          EXPECT_NEAR(end, ray.length_, 1e-6 * ray.length_) << n << " steps, sun " << sun << ", " << elevation;
        }
      }
    }
  }
}

// All converge to one picture, and more steps are never much worse than half as many.
TEST(Distributions, ComeToTheSameLightAndMoreStepsAreNeverWorse) {
  for (const Scene& scene : {earth(), fog(3.0)}) {
    for (const Sight& sight : kSights) {
      Physics p = tableless(scene, sight.sun);
      const vec3 truth = lit(p, sight.altitude, sight.elevation, 3000, physics::kStepsQuadratic);
      for (const unsigned int distribution : kAll) {
        double before = 1e9;
        for (unsigned int n = 8; n <= 2048; n *= 4) {
          const double error = std::abs(lit(p, sight.altitude, sight.elevation, n, distribution).y / truth.y - 1.0);
          // Twice: where errors of opposite sign meet, a coarse rule may be right by chance.
          EXPECT_LE(error, std::max(2.0 * before, 2e-3)) << "sun " << sight.sun << " from " << sight.altitude
                                                         << ", rule " << distribution << ", " << n << " steps";
          before = error;
        }
        EXPECT_LE(before, 2e-3) << "sun " << sight.sun << " from " << sight.altitude << ", rule " << distribution;
      }
    }
  }
}

// Fourth order in smooth air: half the steps' width gives a sixteenth of the error; steps of constant light give a
// quarter.
TEST(Distributions, GaussLegendreIsOfFourthOrder) {
  Physics p = tableless(earth(), 40.0);
  p.media = 2;  // without ozone, whose density has kinks
  const vec3 truth = lit(p, 0.001, 35.0, 4096, physics::kStepsGaussLegendre);
  const auto error = [&](unsigned int n, unsigned int distribution) {
    return std::abs(lit(p, 0.001, 35.0, n, distribution).y / truth.y - 1.0);
  };
  EXPECT_GT(error(16, physics::kStepsGaussLegendre) / error(32, physics::kStepsGaussLegendre), 11.0);
  EXPECT_LT(error(16, physics::kStepsQuadratic) / error(32, physics::kStepsQuadratic), 5.0);
  EXPECT_LT(error(16, physics::kStepsGaussLegendre), 0.1 * error(16, physics::kStepsQuadratic));
}

// The middle is exactly the march without the key; over all places the mean light is the same.
TEST(Jitter, IsUnbiasedOverTheStep) {
  Physics p = tableless(earth(), 20.0);
  for (const unsigned int distribution : {physics::kStepsUniform, physics::kStepsQuadratic}) {
    const vec3 truth = lit(p, 0.001, 15.0, 4096, distribution);
    double mean = 0.0;
    double worst = 0.0;
    constexpr int kPlaces = 64;
    for (int k = 0; k < kPlaces; ++k) {
      const double one = lit(p, 0.001, 15.0, 32, distribution, (k + 0.5) / kPlaces).y / truth.y - 1.0;
      mean += one / kPlaces;
      worst = std::max(worst, std::abs(one));
    }
    EXPECT_LT(std::abs(mean), 0.1 * worst) << distribution;
    EXPECT_LT(std::abs(mean), 3e-3) << distribution;
  }
}

}  // namespace
}  // namespace airlight::test
