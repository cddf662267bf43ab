// The maps of the sky-view table and of the table of factors, and their inverses: on every texel, at the horizon, at
// the sun's azimuth, straight up.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr double kSun = 25.0 * kDegree;
constexpr int kWidth = 48;
constexpr int kRows = 30;
constexpr int kSkyRows = 20;

vec3 direction(double elevation, double azimuth) {
  const double c = std::cos(elevation);
  return {std::sin(azimuth) * c, std::sin(elevation), -std::cos(azimuth) * c};
}

Physics::SkyViewCoordinate texel(Physics& p, int column, int row) {
  Physics::SkyViewCoordinate c;
  c.chord = p.even_from_texel((column + 0.5) / kWidth, kWidth);
  c.ground = row >= kSkyRows;
  c.height =
      p.part_from_texel((row + 0.5) / kRows, c.ground ? kSkyRows : 0, c.ground ? kRows - kSkyRows : kSkyRows, kRows);
  return c;
}

TEST(SkyViewMapping, RayAndCoordinateAreInverseOnEveryTexel) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {1e-4, 0.001, 1.0, 10.0, 60.0, 99.9}) {
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const auto c = texel(p, column, row);
        const Physics::Ray ray = p.sky_view_ray(planet, h, c, std::sin(kSun));
        ASSERT_EQ(ray.at_ground, c.ground);
        ASSERT_GE(ray.length_, 0.0);
        // The horizon's own rows belong to both sides of it.
        const bool horizon = row == 0 || row == kSkyRows;
        const double elevation = std::atan2(ray.mu, std::sqrt(1.0 - ray.mu * ray.mu));
        const vec3 view = direction(elevation, 0.7 + 2.0 * std::asin(c.chord));
        ASSERT_NEAR(ray.nu, physics::dot(view, direction(kSun, 0.7)), 1e-9);
        const auto back = p.sky_view_coordinate(planet, h, view, direction(kSun, 0.7));
        ASSERT_NEAR(back.height, c.height, horizon ? 1e-4 : 1e-7) << h << " km, row " << row;
        if (row != kSkyRows - 1 && row != kRows - 1) {  // every azimuth is the same straight up and down
          ASSERT_NEAR(back.chord, c.chord, 1e-7);
        }
        if (!horizon) {
          ASSERT_EQ(back.ground, c.ground);
        }
      }
    }
  }
}

TEST(SkyViewMapping, FirstRowsHoldTheTrueHorizon) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {0.0, 1e-4, 0.5, 30.0}) {
    const double tangent = p.horizon_mu(planet, h);
    const Physics::Ray sky = p.sky_view_ray(planet, h, texel(p, 5, 0), 0.3);
    const Physics::Ray ground = p.sky_view_ray(planet, h, texel(p, 5, kSkyRows), 0.3);
    EXPECT_NEAR(sky.mu, tangent, 1e-9);
    EXPECT_NEAR(ground.mu, tangent, 2e-9);
    EXPECT_NEAR(ground.length_, p.horizon_distance(planet, h), 1e-3 + 1e-3 * p.horizon_distance(planet, h));
    EXPECT_NEAR(sky.length_, p.horizon_distance(planet, h) + p.horizon_distance(planet, planet.atmosphere_height),
                1e-3);
  }
}

// A coordinate of either part lies between that part's own first and last texel centre: no fetch mixes sky and ground.
TEST(SkyViewMapping, NoFetchStraddlesTheHorizon) {
  Physics p = make_physics(earth());
  EXPECT_DOUBLE_EQ(p.texel_in_part(1.0, 0, kSkyRows, kRows), (kSkyRows - 0.5) / kRows);
  EXPECT_DOUBLE_EQ(p.texel_in_part(0.0, kSkyRows, kRows - kSkyRows, kRows), (kSkyRows + 0.5) / kRows);
  EXPECT_DOUBLE_EQ(p.texel_in_part(1.0, kSkyRows, kRows - kSkyRows, kRows), (kRows - 0.5) / kRows);
}

// Within half a texel of the sun's azimuth a clamped fetch is the first column on either side: no crease.
TEST(SkyViewMapping, IsEvenAndFlatAcrossTheSunsAzimuth) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  EXPECT_DOUBLE_EQ(p.texel_from_even(0.0, kWidth), 0.0);
  EXPECT_DOUBLE_EQ(p.texel_from_even(1.0, kWidth), (kWidth - 0.5) / kWidth);
  double before = -1.0;
  for (double azimuth = 0.0; azimuth <= 180.0; azimuth += 1.5) {
    const auto right =
        p.sky_view_coordinate(planet, 0.1, direction(0.4, 0.7 + azimuth * kDegree), direction(kSun, 0.7));
    const auto left = p.sky_view_coordinate(planet, 0.1, direction(0.4, 0.7 - azimuth * kDegree), direction(kSun, 0.7));
    EXPECT_NEAR(right.chord, left.chord, 1e-9);
    EXPECT_GT(right.chord, before);
    before = right.chord;
  }
  EXPECT_NEAR(before, 1.0, 1e-12);
}

TEST(SkyViewMapping, HoldsStraightUpAndUnderASunStraightUp) {
  Physics p = make_physics(earth());
  const vec3 up{0.0, 1.0, 0.0};
  for (const vec3& sun : {up, direction(kSun, 0.2)}) {
    for (const vec3& view : {up, vec3{0.0, -1.0, 0.0}, direction(0.5, 1.0)}) {
      const auto c = p.sky_view_coordinate(p.scene.planet, 0.2, view, sun);
      EXPECT_TRUE(c.chord >= 0.0 && c.chord <= 1.0 && c.height >= 0.0 && c.height <= 1.0);
    }
  }
  EXPECT_DOUBLE_EQ(p.sky_view_coordinate(p.scene.planet, 0.2, up, direction(kSun, 0.2)).height, 1.0);
}

TEST(SkyTable, RayAndCoordinateAreInverseOnEveryTexel) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  constexpr int kColumns = 24;
  constexpr int kTableRows = 20;
  for (const double h : {0.0, 1e-4, 0.001, 1.0, 10.0, 60.0, 99.9}) {
    for (const physics::uint section : {physics::uint{0}, physics::uint{1}, physics::uint{2}}) {
      for (int row = 0; row < kTableRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
          const double x = static_cast<double>(column) / (kColumns - 1);
          const double y = static_cast<double>(row) / (kTableRows - 1);
          const Physics::SkyTableState state = p.sky_table_state(planet, h, x, section, y);
          ASSERT_LE(std::abs(state.mu), 1.0);
          const auto back = p.sky_table_coordinate(planet, h, state.mu, state.cos_azimuth);
          ASSERT_NEAR(back.x, x, 1e-7);
          // The edges of a section belong to both sides; on the ground itself there is no limb and no way to the
          // ground.
          const bool edge = y == 0.0 || y == 1.0;
          if (!edge && (h > 0.0 || section == 2)) {
            ASSERT_EQ(back.section, section) << h << " km, row " << row;
            ASSERT_NEAR(back.y, y, 1e-6) << h << " km, section " << section << ", row " << row;
          }
        }
      }
    }
  }
}

TEST(SkyTable, SectionsMeetAtTheTrueHorizonAndAtLevel) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {0.001, 10.0, 99.9}) {
    const double horizon = p.horizon_mu(planet, h);
    EXPECT_NEAR(p.sky_table_state(planet, h, 0.0, 0, 1.0).mu, horizon, 1e-9);  // the ground's farthest row
    EXPECT_NEAR(p.sky_table_state(planet, h, 0.0, 1, 0.0).mu, horizon, 1e-12);
    EXPECT_EQ(p.sky_table_state(planet, h, 0.0, 1, 1.0).mu, 0.0);
    EXPECT_EQ(p.sky_table_state(planet, h, 0.0, 2, 0.0).mu, 0.0);
    EXPECT_EQ(p.sky_table_state(planet, h, 0.0, 2, 1.0).mu, 1.0);
    EXPECT_NEAR(p.sky_table_state(planet, h, 0.0, 0, 0.0).mu, -1.0, 1e-12);
  }
}

// Whatever direction of a picture is looked up, the four texels around it are said to be read; most others are not.
TEST(SkyTable, TexelsAroundTheDirectionsOfAPictureAreRead) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  constexpr int kColumns = 24;
  constexpr int kTableRows = 20;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int read = 0;
  int all = 0;
  for (int camera = 0; camera < 40; ++camera) {
    const double h = std::array{0.0, 5e-11, 0.002, 1.0, 12.0}[static_cast<std::size_t>(camera % 5)];
    const vec3 sun = direction(std::asin(2.0 * unit(random) - 1.0), 6.283 * unit(random));
    const vec3 axis = direction(std::asin(2.0 * unit(random) - 1.0), 6.283 * unit(random));
    const Physics::ViewCone cone{axis, 0.05 + unit(random)};
    const auto is_read = [&](physics::uint section, int column, int row) {
      const Physics::SkyTableCoordinate at{static_cast<double>(column) / (kColumns - 1), section,
                                           static_cast<double>(row) / (kTableRows - 1)};
      return p.table_texel_is_read(planet, h, at, 1.0 / (kColumns - 1), 1.0 / (kTableRows - 1), sun, cone);
    };
    for (int i = 0; i < 2000; ++i) {
      const vec3 view = direction(std::asin(2.0 * unit(random) - 1.0), 6.283 * unit(random));
      if (physics::dot(view, axis) < std::cos(cone.half_angle)) {
        continue;
      }
      const double across = std::hypot(view.x, view.z) * std::hypot(sun.x, sun.z);
      const auto at = p.sky_table_coordinate(planet, h, view.y, (view.x * sun.x + view.z * sun.z) / across);
      for (int corner = 0; corner < 4; ++corner) {
        const int column = std::min(static_cast<int>(at.x * (kColumns - 1)) + corner % 2, kColumns - 1);
        const int row = std::min(static_cast<int>(at.y * (kTableRows - 1)) + corner / 2, kTableRows - 1);
        ASSERT_TRUE(is_read(at.section, column, row)) << "camera " << camera << ", " << column << ", " << row;
      }
    }
    for (int texel = 0; texel < 3 * kColumns * kTableRows; ++texel) {
      read += is_read(static_cast<physics::uint>(texel % 3), texel / 3 % kColumns, texel / 3 / kColumns) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_LT(read, all / 2);
}

}  // namespace
}  // namespace airlight::test
