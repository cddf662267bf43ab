// The closed forms and maps of light among things, on double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics/physics.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::uint;
using physics::vec2;
using physics::vec3;

TEST(ThingLight, GridCoordinatesAreInverse) {
  Physics p;
  double before = -1e9;
  for (int k = -999; k <= 999; ++k) {
    const double g = k / 1000.0;
    const double x = p.map_coordinate(g);
    EXPECT_NEAR(p.grid_coordinate(x), g, 1e-12) << g;
    EXPECT_GT(x, before);
    before = x;
  }
  EXPECT_NEAR(p.map_coordinate(p.kMapShare), 1.0, 1e-12);
}

TEST(ThingLight, DirectionsCoverTheSphere) {
  Physics p;
  for (const double elevation : {-0.1, 0.09, 0.8, 0.5 * std::numbers::pi}) {
    const vec3 sun(0.0, std::sin(elevation), -std::cos(elevation));
    double solid_angle = 0.0;
    vec3 mean(0.0);
    for (uint i = 0; i < physics::kLightDirections; ++i) {
      const vec3 d = p.light_direction(i, sun);
      EXPECT_NEAR(physics::length(d), 1.0, 1e-12);
      solid_angle += p.light_weight(i);
      mean = mean + d * p.light_weight(i);
    }
    EXPECT_NEAR(solid_angle, 4.0 * std::numbers::pi, 1e-12);
    EXPECT_LT(physics::length(mean), 0.02 * solid_angle);
  }
}

// The share of an even hemisphere's irradiance whose rays meet the sphere, by a sum over directions.
double hidden_by_sum(Physics& p, const physics::SphereData& s, const vec3& point) {
  constexpr int kSide = 600;
  int hits = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double square = (i + 0.5) / kSide;
      const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
      const vec3 d(std::sqrt(square) * std::cos(turn), std::sqrt(1.0 - square), std::sqrt(square) * std::sin(turn));
      hits += p.distance_to_sphere(s, point, d) > 0.0 ? 1 : 0;
    }
  }
  return hits / static_cast<double>(kSide * kSide);
}

TEST(ThingLight, ASphereHidesWhatItsRaysMeet) {
  Physics p;
  physics::SphereData s{};
  s.radius = 0.7;
  for (const vec3& centre : {vec3(0.0, 1.0, 0.0), vec3(1.0, 1.5, 0.3), vec3(2.0, 0.4, -1.0), vec3(1.1, -0.2, 0.0),
                             vec3(0.71, 0.0, 0.0), vec3(0.3, -2.0, 0.2), vec3(30.0, 4.0, 9.0)}) {
    s.centre = centre;
    const double truth = hidden_by_sum(p, s, vec3(0.0));
    EXPECT_NEAR(p.hidden_by_sphere(s, centre, vec3(0.0, 1.0, 0.0)), truth, 2e-3 * truth + 1e-5) << centre.x;
  }
}

// Mean radiance over the disc that a matte sphere shows, by a sum.
TEST(ThingLight, AMatteSphereShinesByItsPhase) {
  Physics p;
  constexpr int kSide = 400;
  for (const double angle : {0.0, 0.4, 1.2, 0.5 * std::numbers::pi, 2.4, std::numbers::pi}) {
    const vec3 sun(std::sin(angle), 0.0, std::cos(angle));
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const double square = (i + 0.5) / kSide;
        const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
        const vec3 normal(std::sqrt(square) * std::cos(turn), std::sqrt(square) * std::sin(turn),
                          std::sqrt(1.0 - square));
        sum += std::max(physics::dot(normal, sun), 0.0);
      }
    }
    EXPECT_NEAR(p.lit_of_sphere(std::cos(angle)), sum / (kSide * kSide), 2e-4) << angle;
  }
}

}  // namespace
}  // namespace airlight::test
