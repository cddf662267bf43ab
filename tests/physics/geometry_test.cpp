// Distances on the sphere against explicit roots in 80-bit floats, and rays from the ground, the top and space.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::PlanetData;
using Wide = long double;

struct World {
  double radius;
  double height;
};
constexpr World kWorlds[] = {{6360.0, 100.0}, {3389.5, 110.0}, {1.0, 100.0}, {1.0, 0.1}, {1e6, 100.0}, {1e6, 5.0}};

PlanetData planet_of(const World& world) {
  PlanetData planet;
  planet.ground_radius = world.radius;
  planet.atmosphere_height = world.height;
  return planet;
}

// Altitudes inside, as fractions of the atmosphere's height: both ends, one ulp from them, and between.
std::vector<double> altitudes(const World& world) {
  std::vector<double> list{0.0, std::numeric_limits<double>::denorm_min(), 1e-12};
  for (const double f : {1e-7, 1e-5, 1e-3, 0.1, 0.5, 0.999}) {
    list.push_back(f * world.height);
  }
  list.push_back(std::nextafter(world.height, 0.0));
  list.push_back(world.height);
  return list;
}

const std::vector<double>& cosines() {
  static const std::vector<double> list = [] {
    std::vector<double> all{-1.0, 1.0, 0.0};
    for (double x = 1e-9; x < 1.0; x *= 3.0) {
      all.insert(all.end(), {x, -x, 1.0 - x, x - 1.0});
    }
    return all;
  }();
  return list;
}

// Distance from altitude h to the sphere at another altitude: the textbook root of r^2 + 2 r mu t + t^2.
Wide sphere_root(Wide radius, Wide h, Wide mu, Wide altitude, Wide sign) {
  const Wide b = (radius + h) * mu;
  const Wide q = b * b - (h - altitude) * (2.0L * radius + h + altitude);
  return -b + sign * std::sqrt(std::max(q, 0.0L));
}

TEST(Geometry, HorizonIsWhereTheTangentTouches) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double h : altitudes(world)) {
      const Wide r = Wide(world.radius) + h;
      const Wide distance = std::sqrt(Wide(h) * (r + world.radius));
      EXPECT_NEAR(p.horizon_distance(planet, h), double(distance), 1e-14 * double(distance));
      EXPECT_NEAR(p.horizon_mu(planet, h), double(-distance / r), 1e-15);
      // A right triangle: sin^2 + (R/r)^2 = 1.
      EXPECT_NEAR(
          double(Wide(p.horizon_mu(planet, h)) * p.horizon_mu(planet, h) + (world.radius / r) * (world.radius / r)),
          1.0, 1e-14);
    }
    EXPECT_EQ(p.horizon_mu(planet, 0.0), 0.0);
  }
}

TEST(Geometry, OnlyDirectionsBelowTheHorizonMeetTheGround) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double h : altitudes(world)) {
      const double horizon = p.horizon_mu(planet, h);
      EXPECT_FALSE(p.meets_ground(planet, h, horizon));  // the tangent
      EXPECT_FALSE(p.meets_ground(planet, h, std::nextafter(horizon, 1.0)));
      EXPECT_TRUE(p.meets_ground(planet, h, std::nextafter(horizon, -2.0)));
      EXPECT_FALSE(p.meets_ground(planet, h, 0.0));
      EXPECT_TRUE(p.meets_ground(planet, h, -1.0));
    }
  }
}

TEST(Geometry, DistancesAreTheRoots) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double h : altitudes(world)) {
      for (const double mu : cosines()) {
        const double to_top = p.distance_to_top(planet, h, mu);
        const double expected = double(std::max(sphere_root(world.radius, h, mu, world.height, 1.0L), 0.0L));
        // 1e-18 of the radius at the top: the textbook root cancels, even in 80 bits.
        EXPECT_NEAR(to_top, expected, 1e-13 * expected + 1e-18 * (world.radius + world.height))
            << world.radius << ", h " << h << ", mu " << mu;
        EXPECT_GE(to_top, 0.0);
        if (p.meets_ground(planet, h, mu)) {
          const double to_ground = p.distance_to_ground(planet, h, mu);
          const double root = double(std::max(sphere_root(world.radius, h, mu, 0.0L, -1.0L), 0.0L));
          const bool grazes = mu > 1.001 * p.horizon_mu(planet, h);  // the two roots meet: half the digits
          EXPECT_NEAR(to_ground, root, (grazes ? 1e-3 : 1e-9) * root + 1e-18 * world.radius)
              << world.radius << ", h " << h << ", mu " << mu;
          EXPECT_GE(to_ground, 0.0);
          EXPECT_LE(to_ground, to_top + 1e-12 * world.radius);
        }
      }
    }
  }
}

// With a strict "> 0" on the hit distance, rays that start on the ground would march through the planet.
TEST(Geometry, ARayThatStartsOnTheGroundEndsThere) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double mu : {-1e-12, -1e-3, -0.5, -1.0}) {
      EXPECT_EQ(p.distance_to_ground(planet, 0.0, mu), 0.0);
      const auto ray = p.ray_in_atmosphere(planet, 0.0, mu, 0.3, 0.1);
      EXPECT_TRUE(ray.at_ground);
      EXPECT_EQ(ray.length_, 0.0);
    }
    for (const double mu : {0.0, 1e-12, 0.5, 1.0}) {
      const auto ray = p.ray_in_atmosphere(planet, 0.0, mu, 0.3, 0.1);
      EXPECT_FALSE(ray.at_ground);
      EXPECT_EQ(ray.length_, p.distance_to_top(planet, 0.0, mu));
      EXPECT_GE(ray.length_, world.height * (1.0 - 1e-12));
    }
  }
}

TEST(Geometry, RaysEndOnTheGroundOrAtTheTop) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double h : altitudes(world)) {
      for (const double mu : cosines()) {
        const auto ray = p.ray_in_atmosphere(planet, h, mu, 0.4, -0.2);
        ASSERT_GE(ray.length_, 0.0);
        // The altitude of the ray's end in 80 bits, without the clamp of point_on_ray.
        const Wide r = Wide(world.radius) + h;
        const Wide t = ray.length_;
        const Wide end = h + t * (2.0L * r * mu + t) / (std::sqrt(r * r + t * (2.0L * r * mu + t)) + r);
        const double altitude = ray.at_ground ? 0.0 : world.height;
        EXPECT_NEAR(double(end), altitude, 1e-9 * world.radius + 1e-9 * world.height)
            << world.radius << ", h " << h << ", mu " << mu;
      }
    }
  }
}

TEST(Geometry, PointsOnARayAreWhereVectorsPutThem) {
  Physics p{};
  for (const World& world : kWorlds) {
    const PlanetData planet = planet_of(world);
    for (const double h : {0.0, 1e-4 * world.height, 0.3 * world.height, world.height}) {
      for (const double mu : {-0.9, -0.1, -1e-3, 0.0, 0.02, 0.7, 1.0}) {
        const auto ray = p.ray_in_atmosphere(planet, h, mu, 0.6, 0.0);
        // In the plane of view and zenith: start (0, r), view (s, mu); the sun in three dimensions with nu as given.
        const double s = std::sqrt(1.0 - mu * mu);
        const double nu = 0.6 * mu + s * 0.8 * 0.5;
        auto with_sun = ray;
        with_sun.nu = nu;
        for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
          const double t = share * ray.length_;
          const double x = s * t;
          const double y = world.radius + h + mu * t;
          const double r = std::hypot(x, y);
          const auto point = p.point_on_ray(planet, with_sun, t);
          EXPECT_NEAR(point.h, r - world.radius, 1e-11 * world.radius);
          EXPECT_NEAR(point.mu, (x * s + y * mu) / r, 1e-12);
          EXPECT_NEAR(point.mu_sun, ((world.radius + h) * 0.6 + t * nu) / r, 1e-12);
        }
      }
    }
  }
}

TEST(Geometry, ARayFromSpaceEntersAtTheTop) {
  Physics p{};
  const World world{6360.0, 100.0};
  const PlanetData planet = planet_of(world);
  for (const double h : {std::nextafter(100.0, 200.0), 100.001, 500.0, 36000.0, 400000.0}) {
    const double limb = -std::sqrt(1.0 - std::pow(6460.0 / (6360.0 + h), 2));  // tangent to the top
    for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999}) {
      const double mu = -1.0 + share * (limb + 1.0);
      const double nu = 0.2 * mu + 0.3 * std::sqrt(1.0 - mu * mu);
      const auto ray = p.ray_in_atmosphere(planet, h, mu, 0.2, nu);
      const Wide entry = sphere_root(6360.0L, h, mu, 100.0L, -1.0L);
      ASSERT_GT(ray.length_, 0.0) << h << ", " << mu;
      EXPECT_EQ(ray.h, 100.0);
      EXPECT_NEAR(ray.mu, double(((6360.0L + h) * mu + entry) / 6460.0L), 1e-9);
      EXPECT_NEAR(ray.mu_sun, double(((6360.0L + h) * 0.2L + entry * nu) / 6460.0L), 1e-9);
      EXPECT_EQ(ray.nu, nu);
      EXPECT_EQ(ray.at_ground, p.meets_ground(planet, h, mu)) << h << ", " << mu;
      const Wide exit =
          ray.at_ground ? sphere_root(6360.0L, h, mu, 0.0L, -1.0L) : sphere_root(6360.0L, h, mu, 100.0L, 1.0L);
      EXPECT_NEAR(ray.length_, double(exit - entry), 1e-6 * double(exit - entry));
    }
    // Past the limb, level, and away from the planet: no air. Published code marches backward here.
    for (const double mu : {limb + 1e-9, 0.5 * limb, 0.0, 1e-3, 1.0}) {
      EXPECT_LT(p.ray_in_atmosphere(planet, h, mu, 0.2, 0.3).length_, 0.0) << h << ", " << mu;
      EXPECT_FALSE(p.ray_in_atmosphere(planet, h, mu, 0.2, 0.3).at_ground);
    }
  }
}

TEST(Geometry, AtTheTopTheAirLiesBelow) {
  Physics p{};
  const PlanetData planet = planet_of({6360.0, 100.0});
  for (const double mu : {0.0, 1e-9, 0.5, 1.0}) {
    EXPECT_EQ(p.ray_in_atmosphere(planet, 100.0, mu, 0.2, 0.3).length_, 0.0) << mu;
  }
  EXPECT_NEAR(p.ray_in_atmosphere(planet, 100.0, -1.0, 0.2, -0.2).length_, 100.0, 1e-9);
  // One ulp outside, inside and exactly on it are the same place.
  for (const double mu : {-1.0, -0.5, -0.01}) {
    const double at = p.ray_in_atmosphere(planet, 100.0, mu, 0.2, 0.3).length_;
    EXPECT_NEAR(p.ray_in_atmosphere(planet, std::nextafter(100.0, 0.0), mu, 0.2, 0.3).length_, at, 1e-6);
    EXPECT_NEAR(p.ray_in_atmosphere(planet, std::nextafter(100.0, 200.0), mu, 0.2, 0.3).length_, at, 1e-6);
  }
}

// T(a, c) = T(a, b) T(b, c), along rays up, level and down.
TEST(Geometry, TransmittanceMultipliesAlongARay) {
  Physics p = make_physics(earth());
  const PlanetData& planet = p.scene.planet;
  for (const double h : {0.0, 1.0, 30.0}) {
    for (const double mu : {1.0, 0.3, 0.02, 0.0, 0.9 * p.horizon_mu(planet, h)}) {
      const auto ray = p.ray_in_atmosphere(planet, h, mu, mu, 1.0);
      const double whole = p.optical_depth_to_top(planet, h, mu, 4096).z;
      for (const double share : {0.1, 0.5, 0.9}) {
        const double length = share * ray.length_;
        double first = 0.0;
        for (int i = 0; i < 20000; ++i) {
          first += p.extinction_at(p.point_on_ray(planet, ray, length * (i + 0.5) / 20000).h).z * length / 20000;
        }
        const auto b = p.point_on_ray(planet, ray, length);
        EXPECT_NEAR(first + p.optical_depth_to_top(planet, b.h, b.mu, 4096).z, whole, 2e-5 * whole)
            << h << ", " << mu << ", " << share;
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
