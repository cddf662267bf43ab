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
    EXPECT_NEAR(p.mean_transmittance(x) / (-std::expm1(-x) / x), 1.0, 1.8e-9) << x;
  }
  EXPECT_NEAR(p.mean_transmittance(std::nextafter(0.5, 0.0)), p.mean_transmittance(0.5), 1.8e-9);
  EXPECT_EQ(p.mean_transmittance(1e300), 1e-300);
}

// Transfer of a step: each channel is as if it were alone, whatever the others are.
TEST(Segment, TransferIsThatOfEachChannel) {
  Physics p{};
  for (const physics::vec3 x : {physics::vec3(0.0, 1e-9, 0.1), physics::vec3(0.499, 0.5, 3.0),
                                physics::vec3(2.0, 0.2, 1e-5), physics::vec3(1e-4, 700.0, 0.6)}) {
    const Physics::SegmentTransfer s = p.segment_transfer(x);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(channel(s.mean, c), p.mean_transmittance(channel(x, c)));
      EXPECT_NEAR(channel(s.through, c), std::exp(-channel(x, c)), 1e-8);
    }
  }
}

// Steps through constant air add up to the whole, however many there are.
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
