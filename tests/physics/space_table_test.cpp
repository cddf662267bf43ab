// The map of the table of factors of a camera above the air, and its inverse: on every texel, at the planet's edge, and
// for rays that miss the air.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;

constexpr double kGround = 6360.0;
constexpr double kTop = 100.0;

// Zenith cosine at the camera, and its sine, of a ray that passes the planet's centre at `off` km.
struct SpaceView {
  double mu;
  double across;
};

SpaceView past(double off, double h) {
  const double across = off / (kGround + h);
  return {-std::sqrt(1.0 - across * across), across};
}

TEST(SpaceTable, RayAndCoordinateAreInverseOnEveryTexel) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  constexpr int kColumns = 24;
  constexpr int kTableRows = 20;
  for (const double h : {100.001, 120.0, 500.0, 2.0 * kGround, 1e5}) {
    for (const double mu_sun : {1.0, 0.7, 0.02, -0.3, -1.0}) {
      for (const physics::uint section : {physics::uint{0}, physics::uint{1}}) {
        // In the ground's first row the foot is below the camera; the limb's last row grazes the top of the air.
        for (int row = 1; row + 1 < kTableRows; ++row) {
          for (int column = 0; column < kColumns; ++column) {
            const double x = static_cast<double>(column) / (kColumns - 1);
            const double y = static_cast<double>(row) / (kTableRows - 1);
            const Physics::Ray ray = p.space_table_ray(planet, h, mu_sun, x, section, y, 1.0).ray;
            ASSERT_EQ(ray.at_ground, section == 0);
            ASSERT_GT(ray.length_, 0.0);
            const SpaceView view = past((kGround + kTop) * std::sqrt(1.0 - ray.mu * ray.mu), h);
            const double level = view.across * std::sqrt(1.0 - mu_sun * mu_sun);
            const double azimuth = level > 0.0 ? (ray.nu - view.mu * mu_sun) / level : 2.0 * x - 1.0;
            const auto back = p.space_table_coordinate(planet, h, mu_sun, view.mu, view.across, azimuth);
            ASSERT_EQ(back.section, section);
            ASSERT_NEAR(back.y, y, 1e-5) << h << " km, row " << row;
            // Azimuths of rays near the one straight down differ by rounding.
            ASSERT_NEAR(back.x, x, 2e-4) << h << " km, sun " << mu_sun << ", row " << row;
          }
        }
      }
    }
  }
}

// A texel's ray is the part inside the air of its view's ray, by the formula for any ray.
TEST(SpaceTable, ATexelsRayIsThatOfItsView) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {101.0, 500.0, 1e5}) {
    for (const double y : {0.2, 0.6, 0.9}) {
      for (const physics::uint section : {physics::uint{0}, physics::uint{1}}) {
        const Physics::Ray texel = p.space_table_ray(planet, h, 0.3, 0.4, section, y, 1.0).ray;
        const SpaceView view = past((kGround + kTop) * std::sqrt(1.0 - texel.mu * texel.mu), h);
        const Physics::Ray ray = p.ray_in_atmosphere(planet, h, view.mu, 0.3, texel.nu);
        EXPECT_NEAR(ray.mu, texel.mu, 1e-9);
        EXPECT_NEAR(ray.mu_sun, texel.mu_sun, 1e-9);
        EXPECT_NEAR(ray.length_, texel.length_, 1e-6 * texel.length_ + 1e-4);
        EXPECT_EQ(ray.at_ground, texel.at_ground);
      }
    }
  }
}

// Columns go by the sun at the foot: the terminator's column is the same in every row that it crosses.
TEST(SpaceTable, TheTerminatorLiesWhereTheSunAtTheFootIsLevel) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double y : {0.5, 0.8}) {
    const double x = [&] {
      double low = 0.0;
      double high = 1.0;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const Physics::Ray ray = p.space_table_ray(planet, 2.0 * kGround, 0.0, middle, 0, y, 1.0).ray;
        (p.point_on_ray(planet, ray, ray.length_).mu_sun < 0.0 ? low : high) = middle;
      }
      return low;
    }();
    EXPECT_NEAR(x, 0.5, 1e-6) << y;  // the sun stands level at the camera: as much day as night
  }
}

TEST(SpaceTable, RaysThatMissTheAirHaveNoSection) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {101.0, 500.0, 1e5}) {
    for (const double off : {kGround + kTop + 0.5, kGround + h}) {
      const SpaceView view = past(off, h);
      EXPECT_EQ(p.space_table_coordinate(planet, h, 0.3, view.mu, view.across, 0.2).section, p.kSectionNoAir);
    }
    EXPECT_EQ(p.space_table_coordinate(planet, h, 0.3, 1.0, 0.0, 0.2).section, p.kSectionNoAir);
    const SpaceView limb = past(kGround + 0.5 * kTop, h);
    EXPECT_EQ(p.space_table_coordinate(planet, h, 0.3, limb.mu, limb.across, 0.2).section, p.kSectionLimb);
    const SpaceView ground = past(kGround - 1.0, h);
    EXPECT_EQ(p.space_table_coordinate(planet, h, 0.3, ground.mu, ground.across, 0.2).section, p.kSectionGround);
  }
}

}  // namespace
}  // namespace airlight::test
