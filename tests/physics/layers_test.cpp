// Light kept apart: in double its sum is the march's radiance up to rounding, and each part vanishes with its cause.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/host_tables.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

Physics baked(const Scene& scene) {
  Physics p = make_physics(scene);
  bake(p, {32, 16, 4, 8});
  return p;
}

Physics::Ray ray_to(Physics& p, double h, double elevation_deg) {
  const vec3 direction = p.direction_from_angles(elevation_deg * kDegree, 0.4);
  const vec3 sun = p.scene.sun.direction;
  return p.ray_in_atmosphere(p.scene.planet, h, direction.y, sun.y, physics::dot(direction, sun));
}

TEST(MarchLayers, SumUpToTheMarch) {
  Physics p = baked(every_kind());
  p.scene.sun.irradiance = vec3(2.0, 3.0, 5.0);
  for (const double elevation : {80.0, 3.0, -1.0, -40.0}) {
    for (const physics::uint distribution : {physics::kStepsUniform, physics::kStepsQuadratic}) {
      for (const physics::uint steps : {7u, 16u}) {
        const Physics::Ray ray = ray_to(p, 2.0, elevation);
        const auto whole = p.march(p.scene.planet, p.scene.sun, ray, steps, distribution, 0.7);
        const auto layers = p.march_layers(p.scene.planet, p.scene.sun, ray, steps, distribution, 0.7);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(channel(p.sum_of_layers(layers), c) / channel(whole.radiance, c), 1.0, 1e-13) << elevation;
          EXPECT_DOUBLE_EQ(channel(layers.transmittance, c), channel(whole.transmittance, c)) << elevation;
        }
      }
    }
  }
}

TEST(MarchLayers, EachVanishesWithItsCause) {
  Scene scene = every_kind();
  scene.planet.ground_albedo = {};
  scene.media[2].scattering = {};
  Physics p = baked(scene);
  const auto layers =
      p.march_layers(p.scene.planet, p.scene.sun, ray_to(p, 2.0, -40.0), 16, physics::kStepsQuadratic, 0.0);
  EXPECT_EQ(channel(layers.ground, 1), 0.0);
  EXPECT_EQ(channel(layers.multiple, 1), 0.0);
  EXPECT_EQ(channel(layers.single[2], 1), 0.0);
  EXPECT_EQ(channel(layers.single[6], 1), 0.0) << "a medium that is not there";
  EXPECT_GT(channel(layers.single[0], 1), 0.0);
}

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
