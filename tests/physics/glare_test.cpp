// The point spread of glare: its norm, its distribution over the angle, and a comparison with another measured one.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

// Share of the scattered light between two angles, degrees.
double share(double from, double to) {
  physics::Physics p{};
  const int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {  // by the logarithm of the angle
    const double width = std::log(to / from) / n;
    const double angle = from * std::exp((i + 0.5) * width) * kDegree;
    sum += p.glare_spread(angle, 0.0) * 2.0 * std::numbers::pi * std::sin(angle) * angle * width;
  }
  return sum;
}

TEST(Glare, IsNormalisedOverTheHalfSphere) {
  EXPECT_NEAR(share(1e-5, 90.0), 1.0, 0.01);
}

// The figures of presets/README.md.
TEST(Glare, HasASmallCoreAndALongTail) {
  EXPECT_NEAR(share(1e-5, 0.2666), 0.73, 0.03);
  EXPECT_NEAR(share(1.0, 90.0), 0.16, 0.01);
  EXPECT_NEAR(share(10.0, 90.0), 0.06, 0.01);
}

// Spencer's eye beside the standard observer of Vos and van den Berg (CIE 135/1, 1999) without age: 10/a^3 + 5/a^2 per
// steradian at a degrees, good from 0.1 to 30 degrees. Both are means over eyes, which differ from one another as much.
TEST(Glare, FallsOffAsTheStandardObserversDoes) {
  physics::Physics p{};
  for (const double a : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0}) {
    const double eye = (0.478 + 0.138) * p.glare_spread(a * kDegree, 0.0);
    const double standard = 10.0 / (a * a * a) + 5.0 / (a * a);
    EXPECT_GT(eye / standard, 0.5) << a;
    EXPECT_LT(eye / standard, 2.0) << a;
  }
}

TEST(Glare, AngleIsExactAtAnySize) {
  physics::Physics p{};
  for (const double angle : {1e-9, 1e-3, 1.0, 3.1}) {
    const physics::vec3 a(0.0, 1.0, 0.0);
    const physics::vec3 b(std::sin(angle), std::cos(angle), 0.0);
    EXPECT_NEAR(p.angle_between(a, b) / angle, 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace airlight::test
