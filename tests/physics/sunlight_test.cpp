// Sunlight at a point of the air: the planet's shadow, and the disc.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/host_tables.h"
#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::SunData;

Physics in_sunlight(const Scene& scene) {
  Physics p = make_physics(scene);
  p.transmittance_lut = transmittance_table(p, 64, 32);
  return p;
}

TEST(Sunlight, EndsAtThePlanetsShadow) {
  Physics p = in_sunlight(vacuum());
  const auto& planet = p.scene.planet;
  for (const double h : {0.0, 1e-4, 1e-3, 1.0, 30.0, 99.99, 100.0}) {
    const double horizon = p.horizon_mu(planet, h);
    EXPECT_EQ(p.transmittance_to_sun(planet, h, horizon + 1e-15).x, 1.0) << h;  // the tangent, but for rounding
    EXPECT_EQ(p.transmittance_to_sun(planet, h, horizon + 1e-9).x, 1.0) << h;
    EXPECT_EQ(p.transmittance_to_sun(planet, h, horizon - 1e-9).x, 0.0) << h;
    EXPECT_EQ(p.transmittance_to_sun(planet, h, 1.0).x, 1.0) << h;
    EXPECT_EQ(p.transmittance_to_sun(planet, h, -1.0).x, 0.0) << h;
  }
}

// Two degrees after sunset air from 3.9 km up is lit: R (1/cos 2 deg - 1).
TEST(Sunlight, ReachesHighAirAfterSunset) {
  Physics p = in_sunlight(vacuum());
  const double edge = 6360.0 * (1.0 / std::cos(2.0 * kDegree) - 1.0);
  const double mu_sun = std::sin(-2.0 * kDegree);
  EXPECT_EQ(p.transmittance_to_sun(p.scene.planet, edge * 1.0001, mu_sun).x, 1.0);
  EXPECT_EQ(p.transmittance_to_sun(p.scene.planet, edge * 0.9999, mu_sun).x, 0.0);
}

TEST(Sunlight, IsFadedOnlyWhereTheSceneAsksForIt) {
  Scene scene = vacuum();
  Physics plain = make_physics(scene);
  for (const double mu : {-1.0, -0.1, 0.0, 0.3}) {
    EXPECT_EQ(plain.sun_fade(plain.scene.sun, mu), 1.0);
  }
  scene.render.parameters["sun_fade"] = SunFade{10.0, 0.1};
  Physics faded = make_physics(scene);
  EXPECT_EQ(faded.sun_fade(faded.scene.sun, -0.02), 0.0);
  EXPECT_NEAR(faded.sun_fade(faded.scene.sun, 0.04), 0.5, 1e-15);
  EXPECT_EQ(faded.sun_fade(faded.scene.sun, 0.5), 1.0);
}

// Fetches along the line from the table agree with the integral: a table row that is off by half a texel is 5 to 17 %
// too dark at the horizon.
TEST(Sunlight, FetchedFromTheTableIsTheIntegral) {
  Physics p = make_physics(earth());
  p.transmittance_lut = transmittance_table(p, 256, 64);
  const auto& planet = p.scene.planet;
  for (const double h : {0.0, 0.001, 0.1, 3.0, 20.0, 80.0}) {
    const double horizon = p.horizon_mu(planet, h);
    for (const double above : {0.0, 0.001, 0.01, 0.1, 0.5, 1.0}) {
      const double mu = horizon + (1.0 - horizon) * above;
      const auto depth = p.optical_depth_to_top(planet, h, mu, 4096);
      const auto fetched = p.transmittance_to_top(planet, h, mu);
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = std::exp(-channel(depth, c));
        // 2 %: the table has 64 rows of altitude. Sunlight below 1e-3 is of no account.
        EXPECT_NEAR(channel(fetched, c), expected, 0.02 * expected + 2e-5) << h << ", " << mu << ", channel " << c;
      }
    }
  }
}

SunData sun_of(double radius, double limb) {
  SunData sun;
  sun.angular_radius = radius;
  sun.limb_darkening = limb;
  return sun;
}

TEST(SunDisc, ProfileFollowsTheLimbDarkeningLaw) {
  Physics p{};
  for (const double radius : {0.001 * kDegree, 0.2666 * kDegree, 10.0 * kDegree}) {
    const double edge = 2.0 * std::sin(0.5 * radius);
    EXPECT_EQ(p.disc_profile(sun_of(radius, 0.6), 0.0), 1.0);
    EXPECT_NEAR(p.disc_profile(sun_of(radius, 0.6), edge * (1.0 - 1e-12)), 0.4, 1e-5);
    EXPECT_NEAR(p.disc_profile(sun_of(radius, 0.6), 0.6 * edge), 1.0 - 0.6 * 0.2, 1e-12);
    EXPECT_EQ(p.disc_profile(sun_of(radius, 0.6), edge * 1.0001), 0.0);
    EXPECT_EQ(p.disc_profile(sun_of(radius, 0.0), 0.99 * edge), 1.0);
    EXPECT_EQ(p.disc_profile(sun_of(radius, 0.6), 2.0), 0.0);
  }
}

// Mean over the disc: 1 - u/3; and with it the disc's radiance times its solid angle is the irradiance.
TEST(SunDisc, CarriesTheSunsIrradiance) {
  Physics formulas{};
  for (const double radius : {0.001 * kDegree, 0.2666 * kDegree, 10.0 * kDegree}) {
    for (const double limb : {0.0, 0.6, 1.0}) {
      const double edge = 2.0 * std::sin(0.5 * radius);
      // Solid angle in chords: pi chord^2 out to a chord. Substituted so that the limb's square root is smooth.
      const double mean = integral(
          [&](double mu) {
            return 2.0 * mu * formulas.disc_profile(sun_of(radius, limb), edge * std::sqrt(1.0 - mu * mu));
          },
          1e-9, 1.0, 50);
      EXPECT_NEAR(mean, 1.0 - limb / 3.0, 1e-8) << radius << ", " << limb;
      Scene scene = vacuum();
      scene.sun.irradiance = {1.0, 20.0, 0.5};
      scene.sun.disc.angular_radius = radius;
      scene.sun.disc.limb_darkening = limb;
      const auto centre = make_physics(scene).scene.sun.disc_radiance;
      const double solid_angle = std::numbers::pi * edge * edge;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(channel(centre, c) * mean * solid_angle / scene.sun.irradiance[c], 1.0, 1e-8);
      }
      scene.sun.disc.radiance_scale = 0.25;
      EXPECT_DOUBLE_EQ(make_physics(scene).scene.sun.disc_radiance.x, 0.25 * centre.x);
    }
  }
}

}  // namespace
}  // namespace airlight::test
