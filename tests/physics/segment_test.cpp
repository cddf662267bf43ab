// (1 - exp(-x)) / x, and marches through constant air.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

TEST(Segment, MeanTransmittanceIsExpm1OverX) {
  Physics p{};
  EXPECT_EQ(p.mean_transmittance(0.0), 1.0);
  for (double exponent = -12.0; exponent <= 3.0; exponent += 0.01) {
    const double x = std::pow(10.0, exponent);
    // 1.1e-8: the series' first term left out, x^8/9!, at x = 1/2.
    EXPECT_NEAR(p.mean_transmittance(x) / (-std::expm1(-x) / x), 1.0, 1.2e-8) << x;
  }
  EXPECT_NEAR(p.mean_transmittance(std::nextafter(0.5, 0.0)), p.mean_transmittance(0.5), 1.2e-8);
  EXPECT_EQ(p.mean_transmittance(1e300), 1e-300);
}

// Steps through air that does not change add up to the whole, however many there are.
TEST(Segment, AddsUpToTheWholePath) {
  Physics p{};
  for (const double depth : {1e-9, 1e-3, 0.7, 20.0}) {
    for (const int steps : {1, 2, 32, 1024, 65536}) {
      double gathered = 0.0;
      const double step = depth / steps;
      for (int i = 0; i < steps; ++i) {
        gathered += std::exp(-step * i) * p.mean_transmittance(step) * step;
      }
      EXPECT_NEAR(gathered / -std::expm1(-depth), 1.0, 2e-8) << depth << ", " << steps;
    }
  }
}

}  // namespace
}  // namespace airlight::test
