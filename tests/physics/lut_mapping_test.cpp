// Each table's map and its inverse: on every texel centre, in both directions, at the corners, in order.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::PlanetData;

struct Size {
  int width;
  int height;
};
constexpr Size kSizes[] = {{256, 64}, {2, 2}, {3, 5}, {64, 16}, {17, 100}, {1024, 256}};

PlanetData planet_of(double radius, double height) {
  PlanetData planet;
  planet.ground_radius = radius;
  planet.atmosphere_height = height;
  return planet;
}

const PlanetData kPlanets[] = {planet_of(6360.0, 100.0), planet_of(3389.5, 110.0), planet_of(1.0, 100.0),
                               planet_of(1e6, 100.0), planet_of(6360.0, 0.5)};

template <class F>
void for_every_texel(const Size& size, const F& f) {
  for (int j = 0; j < size.height; ++j) {
    for (int i = 0; i < size.width; ++i) {
      f(static_cast<double>(i) / (size.width - 1), static_cast<double>(j) / (size.height - 1));
    }
  }
}

TEST(LutMapping, UnitRangeSpansTheTexelCentres) {
  Physics p{};
  for (const double n : {2.0, 3.0, 32.0, 256.0, 4096.0}) {
    EXPECT_DOUBLE_EQ(p.texel_from_unit(0.0, n), 0.5 / n);
    EXPECT_DOUBLE_EQ(p.texel_from_unit(1.0, n), (n - 0.5) / n);
    for (double i = 0.0; i < n; i += 1.0) {
      EXPECT_NEAR(p.texel_from_unit(i / (n - 1.0), n), (i + 0.5) / n, 1e-15);
      EXPECT_NEAR(p.unit_from_texel((i + 0.5) / n, n), i / (n - 1.0), 1e-12);
    }
  }
}

TEST(LutMapping, TransmittanceMapAndInverseAreInverseOnEveryTexel) {
  Physics p{};
  for (const PlanetData& planet : kPlanets) {
    for (const Size& size : kSizes) {
      for_every_texel(size, [&](double x, double y) {
        const auto state = p.transmittance_state(planet, x, y);
        ASSERT_GE(state.h, 0.0);
        ASSERT_LE(state.h, planet.atmosphere_height);
        ASSERT_GE(state.mu, -1.0);
        ASSERT_LE(state.mu, 1.0);
        const auto back = p.transmittance_coordinate(planet, state.h, state.mu);
        // In texels; the last row's x is the ratio of two lengths that vanish at the very top, x = 0 there.
        const bool top_zenith = y == 1.0 && x == 0.0;
        ASSERT_NEAR(back.x * (size.width - 1), x * (size.width - 1), top_zenith ? 1e-5 : 1e-6)
            << planet.ground_radius << ": " << x << ", " << y;
        ASSERT_NEAR(back.y * (size.height - 1), y * (size.height - 1), 1e-6) << x << ", " << y;
      });
    }
  }
}

// Quantities -> coordinates -> quantities, over all altitudes and directions above the horizon.
TEST(LutMapping, TransmittanceStateComesBackFromItsCoordinate) {
  Physics p{};
  for (const PlanetData& planet : kPlanets) {
    for (const double share : {0.0, 1e-7, 1e-4, 0.01, 0.3, 0.9, 0.9999}) {
      const double h = share * planet.atmosphere_height;
      const double horizon = p.horizon_mu(planet, h);
      for (double u = 0.0; u <= 1.0; u += 1.0 / 64.0) {
        const double mu = horizon + (1.0 - horizon) * u * u;
        const auto c = p.transmittance_coordinate(planet, h, mu);
        const auto state = p.transmittance_state(planet, c.x, c.y);
        EXPECT_NEAR(state.h, h, 1e-9 * planet.atmosphere_height) << h << ", " << mu;
        EXPECT_NEAR(state.mu, mu, 1e-7) << planet.ground_radius << ": " << h << ", " << mu;
      }
    }
  }
}

TEST(LutMapping, TransmittanceCornersAreZenithAndHorizonAtGroundAndTop) {
  Physics p{};
  const PlanetData& planet = kPlanets[0];
  EXPECT_EQ(p.transmittance_state(planet, 0.0, 0.0).h, 0.0);
  EXPECT_NEAR(p.transmittance_state(planet, 0.0, 0.0).mu, 1.0, 1e-12);
  EXPECT_NEAR(p.transmittance_state(planet, 1.0, 0.0).mu, 0.0, 1e-12);
  EXPECT_NEAR(p.transmittance_state(planet, 0.0, 1.0).h, 100.0, 1e-9);
  // At the very top every direction from level up has distance 0: the corner stands for all of them.
  EXPECT_NEAR(p.distance_to_top(planet, 100.0, p.transmittance_state(planet, 0.0, 1.0).mu), 0.0, 1e-9);
  EXPECT_NEAR(p.transmittance_state(planet, 1.0, 1.0).mu, p.horizon_mu(planet, 100.0), 1e-12);
}

TEST(LutMapping, TransmittanceIsMonotonous) {
  Physics p{};
  for (const PlanetData& planet : kPlanets) {
    for (int j = 0; j < 64; ++j) {
      double before = 2.0;
      for (int i = 0; i < 256; ++i) {
        const double mu = p.transmittance_state(planet, i / 255.0, j / 63.0).mu;
        // In the top row the near end is mu = 1, and mu falls at once to the level direction's neighbourhood.
        ASSERT_LT(mu, before) << planet.ground_radius << ": " << i << ", " << j;
        before = mu;
      }
    }
    double before = -1.0;
    for (int j = 0; j < 64; ++j) {
      const double h = p.transmittance_state(planet, 0.5, j / 63.0).h;
      ASSERT_GT(h, before);
      before = h;
    }
  }
}

// Below the horizon the map still uses the distance to the top, not to the ground: the table's far edge is the horizon,
// directions just below are clamped to it, and nothing jumps.
TEST(LutMapping, IsNeverClippedByTheGround) {
  Physics p{};
  const PlanetData& planet = kPlanets[0];
  for (const double h : {0.0, 0.001, 1.0, 50.0, 99.0}) {
    const double horizon = p.horizon_mu(planet, h);
    EXPECT_NEAR(p.transmittance_coordinate(planet, h, horizon).x, 1.0, 1e-9) << h;
    EXPECT_EQ(p.transmittance_coordinate(planet, h, horizon - 1e-3).x, 1.0) << h;
    EXPECT_EQ(p.transmittance_coordinate(planet, h, -1.0).x, 1.0) << h;
    EXPECT_NEAR(p.transmittance_coordinate(planet, h, 1.0).x, 0.0, 1e-9) << h;
  }
  // At 1 m the row reaches the true horizon, 0.03 degrees below level.
  EXPECT_NEAR(p.transmittance_coordinate(planet, 0.001, p.horizon_mu(planet, 0.001)).x, 1.0, 1e-9);
  EXPECT_LT(p.transmittance_coordinate(planet, 0.001, 0.0).x, 1.0 - 1e-3);
}

TEST(LutMapping, ScatteringMapAndInverseAreInverseOnEveryTexel) {
  Physics p{};
  for (const PlanetData& planet : kPlanets) {
    for (const Size& size : kSizes) {
      for_every_texel(size, [&](double x, double y) {
        const auto state = p.scattering_state(planet, x, y);
        const auto back = p.scattering_coordinate(planet, state.h, state.mu_sun);
        ASSERT_NEAR(back.x, x, 1e-14);
        ASSERT_NEAR(back.y, y, 1e-14);
      });
    }
    EXPECT_EQ(p.scattering_state(planet, 0.0, 0.0).h, 0.0);
    EXPECT_EQ(p.scattering_state(planet, 0.0, 0.0).mu_sun, -1.0);
    EXPECT_EQ(p.scattering_state(planet, 1.0, 1.0).h, planet.atmosphere_height);
    EXPECT_EQ(p.scattering_state(planet, 1.0, 1.0).mu_sun, 1.0);
    // x and y have one unit each: an altitude of 0.01 km is 0.01 km, whatever the atmosphere's height.
    EXPECT_NEAR(p.scattering_coordinate(planet, 0.01 * planet.atmosphere_height, 0.0).y, 0.01, 1e-15);
  }
}

// The host's table: exact at centres, linear between, constant outside. Tests use it in place of a sampler.
TEST(HostTable, SamplesAsTheDeviceDoes) {
  physics::HostTable table;
  table.width = 3;
  table.height = 2;
  for (int i = 0; i < 6; ++i) {
    table.texels.emplace_back(i, 10.0 * i, -i);
  }
  EXPECT_NEAR(table.fetch_unit(0.0, 0.0).x, 0.0, 1e-15);
  EXPECT_NEAR(table.fetch_unit(0.5, 0.0).x, 1.0, 1e-15);
  EXPECT_NEAR(table.fetch_unit(1.0, 1.0).y, 50.0, 1e-13);
  EXPECT_NEAR(table.fetch_unit(0.25, 0.5).x, 2.0, 1e-15);
  EXPECT_NEAR(table.fetch(-3.0, 9.0).z, -3.0, 1e-15);
  physics::HostTable one;
  one.width = 1;
  one.height = 1;
  one.texels.emplace_back(7.0, 8.0, 9.0);
  EXPECT_EQ(one.fetch(0.9, 0.1).y, 8.0);
  EXPECT_TRUE(std::isnan(table.fetch(std::nan(""), 0.5).x));
  EXPECT_TRUE(std::isnan(table.fetch(0.5, std::nan("")).z));
}

}  // namespace
}  // namespace airlight::test
