// The distance to the end of a ray, which the layer of depth holds.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

// In both directions: a ray that leaves the air at a distance enters it there in reverse.
TEST(Geometry, DistanceToTheEndOfARay) {
  Physics p = make_physics(earth());
  const physics::PlanetData planet = p.scene.planet;
  const double radius = planet.ground_radius;
  const double top = planet.atmosphere_height;
  EXPECT_DOUBLE_EQ(p.distance_to_end(planet, 2.0, 1.0), top - 2.0);
  EXPECT_DOUBLE_EQ(p.distance_to_end(planet, 2.0, -1.0), 2.0);
  EXPECT_NEAR(p.distance_to_end(planet, 400.0, -1.0), 400.0, 1e-9);
  EXPECT_LT(p.distance_to_end(planet, 400.0, 0.1), 0.0) << "away from the planet";
  EXPECT_LT(p.distance_to_end(planet, 400.0, -0.05), 0.0) << "past the air";
  // A ray that grazes the air at 50 km leaves it as far after its lowest point as it entered before it.
  const double r = radius + 400.0;
  const double lowest = radius + 50.0;
  const double half = std::sqrt((radius + top) * (radius + top) - lowest * lowest);
  const double to_lowest = std::sqrt(r * r - lowest * lowest);
  EXPECT_NEAR(p.distance_to_end(planet, 400.0, -to_lowest / r), to_lowest + half, 1e-8);
}

}  // namespace
}  // namespace airlight::test
