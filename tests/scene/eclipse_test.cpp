// The moon before the sun.

#include <cmath>
#include <numbers>

#include "core/scene/readers.h"
#include "tests/scene/scene_fixture.h"

namespace airlight {
namespace {

constexpr double kPi = std::numbers::pi;

// The area that two discs of radius 1 have in common, over one disc's, in closed form.
double lens(double apart) {
  return (2.0 * std::acos(0.5 * apart) - 0.5 * apart * std::sqrt(4.0 - apart * apart)) / kPi;
}

TEST(Eclipse, OfAnEvenDiscCoversTheLensOfTwoCircles) {
  for (const double apart : {0.1, 0.5, 1.0, 1.7}) {
    EXPECT_NEAR(uncovered_share(1.0, 0.0, 1.0, apart), 1.0 - lens(apart), 2e-4) << apart;
  }
}

TEST(Eclipse, LeavesARingOrNothing) {
  EXPECT_EQ(uncovered_share(1.0, 0.6, 1.05, 0.04), 0.0);
  EXPECT_NEAR(uncovered_share(1.0, 0.0, 0.9, 0.05), 1.0 - 0.81, 1e-3);
  // The ring is the dark limb: with u = 1 its light is the integral of mu over it, (1 - r^2)^(3/2).
  EXPECT_NEAR(uncovered_share(1.0, 1.0, 0.9, 0.0), std::pow(1.0 - 0.81, 1.5), 1e-3);
  EXPECT_EQ(uncovered_share(1.0, 0.6, 0.95, 2.0), 1.0);
}

// The limb gives less than its area: a small bite takes less light than of an even disc.
TEST(Eclipse, TakesLittleOfTheLimb) {
  EXPECT_LT(1.0 - uncovered_share(1.0, 0.6, 1.0, 1.7), 0.9 * lens(1.7));
}

}  // namespace
}  // namespace airlight
