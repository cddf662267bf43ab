// Places of a march's steps: they cover the ray once, in order.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

struct Leg {
  double falling;  // distance of the lowest point
  double length;
};

// Rays that rise, fall, dip and rise again, with the lowest point at either end and just inside it.
constexpr Leg kLegs[] = {{-50.0, 100.0}, {0.0, 100.0},   {1e-9, 100.0},  {0.3, 100.0},          {50.0, 100.0},
                         {99.7, 100.0},  {100.0, 100.0}, {400.0, 100.0}, {100.0 - 1e-9, 100.0}, {1100.0, 2200.0},
                         {-3.0, 1e-6},   {5.0, 1e-6},    {0.5e-6, 1e-6}};
constexpr unsigned int kCounts[] = {1, 2, 3, 7, 32, 255, 4096};

TEST(Quadrature, StepsCoverTheRayInOrder) {
  Physics p{};
  for (const unsigned int distribution : {physics::kStepsUniform, physics::kStepsQuadratic}) {
    for (const Leg& leg : kLegs) {
      for (const unsigned int n : kCounts) {
        const unsigned int before = p.falling_steps(leg.falling, leg.length, n);
        EXPECT_LE(before, n);
        double sum = 0.0;
        for (unsigned int i = 0; i < n; ++i) {
          const auto step = p.ray_step(distribution, leg.falling, leg.length, before, i, n);
          ASSERT_GT(step.width, 0.0) << leg.falling << ", " << leg.length << ", " << i << " of " << n;
          // The middle of its own width: no gap to the step before, no overlap.
          ASSERT_NEAR(step.t, sum + 0.5 * step.width, 1e-12 * leg.length) << i << " of " << n;
          sum += step.width;
        }
        EXPECT_NEAR(sum / leg.length, 1.0, 1e-12) << leg.falling << ", " << leg.length << ", " << n;
      }
    }
  }
}

TEST(Quadrature, UniformStepsAreEqual) {
  Physics p{};
  for (const Leg& leg : kLegs) {
    const unsigned int before = p.falling_steps(leg.falling, leg.length, 32);
    for (unsigned int i = 0; i < 32; ++i) {
      EXPECT_NEAR(p.ray_step(physics::kStepsUniform, leg.falling, leg.length, before, i, 32).width, leg.length / 32.0,
                  1e-12 * leg.length);
    }
  }
}

// Quadratic steps grow away from the lowest point, at which an edge lies.
TEST(Quadrature, QuadraticStepsAreDensestAtTheLowestPoint) {
  Physics p{};
  for (const Leg& leg : {Leg{-50.0, 100.0}, Leg{30.0, 100.0}, Leg{100.0, 100.0}}) {
    const double lowest = std::min(std::max(leg.falling, 0.0), leg.length);
    const unsigned int before = p.falling_steps(leg.falling, leg.length, 64);
    double edge = 0.0;
    double nearest_edge = std::abs(lowest);
    double width_before = 0.0;
    for (unsigned int i = 0; i < 64; ++i) {
      const auto step = p.ray_step(physics::kStepsQuadratic, leg.falling, leg.length, before, i, 64);
      if (i > 0 && step.t < lowest) {
        EXPECT_LT(step.width, width_before);
      }
      if (i > 0 && step.t - step.width > lowest) {
        EXPECT_GT(step.width, width_before);
      }
      width_before = step.width;
      edge += step.width;
      nearest_edge = std::min(nearest_edge, std::abs(edge - lowest));
    }
    EXPECT_NEAR(nearest_edge, 0.0, 1e-9) << leg.falling;
  }
}

// Midpoints on both sides of the lowest point of a symmetric ray see the same air.
TEST(Quadrature, IsSymmetricOnASymmetricRay) {
  Physics p{};
  const unsigned int before = p.falling_steps(500.0, 1000.0, 40);
  EXPECT_EQ(before, 20U);
  for (unsigned int i = 0; i < 20; ++i) {
    const auto near = p.ray_step(physics::kStepsQuadratic, 500.0, 1000.0, before, i, 40);
    const auto far = p.ray_step(physics::kStepsQuadratic, 500.0, 1000.0, before, 39 - i, 40);
    EXPECT_NEAR(near.width, far.width, 1e-10);
    EXPECT_NEAR(500.0 - near.t, far.t - 500.0, 1e-10);
  }
}

}  // namespace
}  // namespace airlight::test
