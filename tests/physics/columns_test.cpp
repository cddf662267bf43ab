// Columns of exponentials on a sphere in closed form, against quadrature and against the special function that they
// approximate.

#include <gtest/gtest.h>

#include <cmath>

#include "core/methods/analytic_sky.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

TEST(Columns, ScaledErfcIsWithinATenthOfAPercent) {
  Physics p{};
  EXPECT_DOUBLE_EQ(p.scaled_erfc(0.0), 1.0);
  for (double x = 1e-4; x < 5.0; x *= 1.1) {
    const double truth = std::exp(x * x) * std::erfc(x);
    EXPECT_NEAR(p.scaled_erfc(x), truth, 9e-4 * truth) << x;
  }
  // 1/(x sqrt(pi)) (1 - 1/(2 x^2)) far out
  for (const double x : {20.0, 200.0, 1e4}) {
    const double truth = (1.0 - 0.5 / (x * x)) / (x * std::sqrt(std::numbers::pi));
    EXPECT_NEAR(p.scaled_erfc(x), truth, 9e-4 * truth) << x;
  }
}

TEST(Columns, MeanExponentialIsExactWhereverItsEndsLie) {
  Physics p{};
  for (const double a : {0.0, 0.3, 20.0, -2.0}) {
    for (const double d : {0.0, 1e-9, 0.01, 0.29999, 0.30001, 5.0, 80.0, -0.2, -3.0}) {
      const double truth = d == 0.0 ? std::exp(-a) : -std::exp(-a) * std::expm1(-d) / d;
      EXPECT_NEAR(p.mean_exponential(a, a + d), truth, 1e-6 * truth) << a << " " << d;
    }
  }
}

// One exponential medium, from the ground and from 10 km, up, level, and down past the lowest point: 0.2 %.
TEST(Columns, OfAnExponentialAreItsQuadrature) {
  for (const double scale_height : {1.2, 8.0}) {
    Scene scene = vacuum();
    scene.media = {medium("air", {1.0, 1.0, 1.0}, {}, exponential(scale_height))};
    Physics p = make_analytic_physics(part_of(scene));
    EXPECT_DOUBLE_EQ(p.analytic.media[0].base, 0.0);
    for (const double h : {0.0, 3.0, 10.0}) {
      for (const double mu : {1.0, 0.4, 0.05, 0.0, 0.9 * p.horizon_mu(p.scene.planet, h)}) {
        const double truth = p.optical_depth_to_top(p.scene.planet, h, mu, 4000).x;
        EXPECT_NEAR(p.column_to_space(p.scene.planet, p.analytic.media[0], h, mu), truth, 0.002 * truth)
            << scale_height << " km, from " << h << " km, mu " << mu;
      }
    }
  }
}

// A tent and a slab: the vertical column is exact, the slanted one within 3 % down to 10 degrees.
TEST(Columns, OfOtherProfilesKeepColumnMeanAndSpread) {
  for (const Density& density : {tent(25.0, 15.0), constant(4.0), lorentzian(20.0, 12.0, 4.0)}) {
    Scene scene = vacuum();
    scene.media = {medium("air", {1.0, 1.0, 1.0}, {}, density)};
    Physics p = make_analytic_physics(part_of(scene));
    for (const double mu : {1.0, 0.5, 0.17}) {
      const double truth = p.optical_depth_to_top(p.scene.planet, 0.0, mu, 4000).x;
      EXPECT_NEAR(p.column_to_space(p.scene.planet, p.analytic.media[0], 0.0, mu), truth, 0.03 * truth) << mu;
    }
  }
}

TEST(Columns, LowestAltitudeIsTheTangent) {
  Physics p = make_physics(earth());
  for (const double h : {0.0, 0.001, 10.0, 400.0}) {
    EXPECT_NEAR(p.lowest_altitude(p.scene.planet, h, p.horizon_mu(p.scene.planet, h)), 0.0, 1e-9);
    EXPECT_DOUBLE_EQ(p.lowest_altitude(p.scene.planet, h, 0.0), h);
  }
}

}  // namespace
}  // namespace airlight::test
