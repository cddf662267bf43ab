// Multiple scattering: energy, the isotropic phase at both events, ground and sky irradiance.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/host_tables.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr double kPi = std::numbers::pi;

Physics with_transmittance(const Scene& scene) {
  Physics p = make_physics(scene);
  p.transmittance_lut = transmittance_table(p, 128, 32);
  return p;
}

// Air that absorbs nothing over white ground.
Scene lossless(double optical_depth) {
  Scene scene = vacuum();
  const double scattering = optical_depth / 8.0;
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  scene.media = {medium("air", {scattering, 0.5 * scattering, 0.01 * scattering}, {}, exponential(8.0))};
  return scene;
}

TEST(MultipleScattering, DirectionsCoverTheSphereEvenly) {
  Physics p = make_physics(vacuum());
  double mu = 0.0;
  double mu2 = 0.0;
  double nu = 0.0;
  double nu2 = 0.0;
  for (unsigned int k = 0; k < physics::kMultipleScatteringDirections; ++k) {
    const auto ray = p.gather_ray(p.scene.planet, 50.0, 0.4, k);
    mu += ray.mu / 64.0;
    mu2 += ray.mu * ray.mu / 64.0;
    nu += ray.nu / 64.0;
    nu2 += ray.nu * ray.nu / 64.0;
    EXPECT_EQ(ray.mu_sun, 0.4);
    EXPECT_LE(std::abs(ray.nu), 1.0);
  }
  EXPECT_NEAR(mu, 0.0, 1e-12);
  EXPECT_NEAR(nu, 0.0, 1e-12);
  EXPECT_NEAR(mu2, 1.0 / 3.0 - 1.0 / 192.0, 1e-12);  // 8 midpoints of mu^2: short by 4/(12 x 64)
  EXPECT_NEAR(nu2, 1.0 / 3.0, 0.003);
}

// Without absorption, over white ground, a unit field arrives whole from every direction that ends on the ground, and
// from every other direction less the light that leaves to space.
TEST(MultipleScattering, LosesNothingWithoutAbsorptionOverWhiteGround) {
  for (const double depth : {1e-4, 0.3, 5.0, 1000.0}) {
    Physics p = with_transmittance(lossless(depth));
    for (const double h : {0.0, 0.5, 20.0, 100.0}) {
      for (unsigned int k = 0; k < physics::kMultipleScatteringDirections; ++k) {
        const auto ray = p.gather_ray(p.scene.planet, h, 0.3, k);
        const auto gather = p.gather_scattering(p.scene.planet, p.scene.sun, ray, physics::kMultipleScatteringSteps);
        for (std::size_t c = 0; c < 3; ++c) {
          const double transfer = channel(gather.transfer, c);
          if (ray.at_ground) {
            EXPECT_NEAR(transfer, 1.0, 1e-8) << depth << ", " << h << ", " << k;
          } else {
            EXPECT_GE(transfer, 0.0);
            EXPECT_LE(transfer, 1.0 + 1e-12);
          }
        }
      }
    }
  }
}

TEST(MultipleScattering, AbsorptionAndDarkGroundTakeTheirShare) {
  Scene scene = lossless(0.3);
  scene.planet.ground_albedo = {0.25, 0.25, 0.25};
  Physics half = with_transmittance(scene);
  scene.media[0].absorption = scene.media[0].scattering;
  Physics absorbing = with_transmittance(scene);
  Physics black = absorbing;
  black.scene.planet.ground_albedo = vec3(0.0);
  const auto straight_down = [](Physics& p) {
    auto ray = p.ray_in_atmosphere(p.scene.planet, 100.0, -1.0, 0.3, 0.0);
    return p.gather_scattering(p.scene.planet, p.scene.sun, ray, 4096).transfer.x;
  };
  // T = exp(-depth): the ground's light comes through it; the air's own light is the albedo times 1 - T.
  EXPECT_NEAR(straight_down(half), 1.0 - std::exp(-0.3) + 0.25 * std::exp(-0.3), 1e-5);
  EXPECT_NEAR(straight_down(absorbing), 0.5 * (1.0 - std::exp(-0.6)) + 0.25 * std::exp(-0.6), 1e-5);
  EXPECT_NEAR(straight_down(black), 0.5 * (1.0 - std::exp(-0.6)), 1e-5);
}

// Thin air: second order is sunlight scattered once, over 4 pi; published code leaves the 4 pi out.
TEST(MultipleScattering, HasTheIsotropicPhaseAtBothEvents) {
  Scene scene = vacuum();
  scene.media = {medium("thin", {1e-6, 1e-6, 1e-6}, {}, constant(200.0))};
  Physics p = with_transmittance(scene);
  const auto ray = p.ray_in_atmosphere(p.scene.planet, 0.0, 1.0, 1.0, 1.0);
  const auto gather = p.gather_scattering(p.scene.planet, p.scene.sun, ray, physics::kMultipleScatteringSteps);
  EXPECT_NEAR(gather.second_order.x / (1e-6 * 100.0 / (4.0 * kPi)), 1.0, 2e-4);
  // The ground as the first event: albedo mu_sun / pi, seen straight down, the same in all directions.
  Scene white = vacuum();
  white.planet.ground_albedo = {1.0, 0.5, 0.0};
  Physics ground = with_transmittance(white);
  const auto down = ground.ray_in_atmosphere(ground.scene.planet, 10.0, -1.0, 0.6, -0.6);
  const auto seen = ground.gather_scattering(ground.scene.planet, ground.scene.sun, down, 20);
  EXPECT_NEAR(seen.second_order.x, 0.6 / kPi, 1e-12);
  EXPECT_NEAR(seen.second_order.y, 0.3 / kPi, 1e-12);
  EXPECT_EQ(seen.second_order.z, 0.0);
}

// The inner march uses the planet's shadow: at midnight nothing below the shadow's edge is lit.
TEST(MultipleScattering, StaysDarkInThePlanetsShadow) {
  Physics p = with_transmittance(earth());
  const auto midnight = mean_gather(p, 0.0, -1.0);
  EXPECT_EQ(midnight.second_order.z, 0.0);
  EXPECT_GT(midnight.transfer.z, 0.0);
  EXPECT_GT(mean_gather(p, 0.0, std::sin(-4.0 * kDegree)).second_order.z, 0.0);
  EXPECT_GT(mean_gather(p, 0.0, 0.3).second_order.z,
            100.0 * mean_gather(p, 0.0, std::sin(-6.0 * kDegree)).second_order.z);
}

TEST(MultipleScattering, SumsAGeometricSeries) {
  Physics p = make_physics(vacuum());
  const vec3 second(0.25, 1.0, 3.0);
  const vec3 sum = p.sum_of_orders(second, vec3(0.0, 0.5, 0.9));
  EXPECT_DOUBLE_EQ(sum.x, 0.25);
  EXPECT_DOUBLE_EQ(sum.y, 2.0);
  EXPECT_NEAR(sum.z, 30.0, 1e-12);
  // The sum stays finite as the transfer nears 1, and a rounding beyond 1 does not turn it negative.
  EXPECT_NEAR(p.sum_of_orders(second, vec3(1.0, 1.0, 1.0 + 1e-9)).x, 250.0, 1e-9);
  EXPECT_GT(p.sum_of_orders(second, vec3(1.0, 1.0, 1.0 + 1e-9)).z, 0.0);
}

// At noon no channel gives the ground more light than arrives; a table 4 pi too bright gives 1.3 to 2 times as much in
// blue.
TEST(MultipleScattering, GivesTheGroundNoMoreThanArrives) {
  const auto arrives = [](const Scene& scene) {
    Physics p = make_physics(scene);
    bake(p, {128, 32, 16, 64});
    const vec3 sky = ground_irradiance_table(p, 3).fetch_unit(1.0, 0.0);
    const vec3 sun = p.transmittance_to_sun(p.scene.planet, 0.0, 1.0);
    return sky + sun;
  };
  Scene scene = earth();
  const vec3 physical = arrives(scene);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LT(channel(physical, c), 1.0) << c;
    EXPECT_GT(channel(physical, c), 0.7) << c;
  }
  scene.render.parameters["multiple_scattering_scale"] = 4.0 * kPi;
  EXPECT_GT(arrives(scene).z, 1.0);  // the test can tell
}

// Conservative Rayleigh air, sun at the zenith, black ground: the light at the ground is a slab's transmittance, by
// Eddington's approximation (5 - exp(-tau)) / (4 + 3 tau) for a sun at the zenith; the curvature has no effect.
TEST(MultipleScattering, TransmitsWhatASlabTransmits) {
  Scene scene = vacuum();
  scene.media = {medium("air", {0.25 / 8.0, 0.25 / 8.0, 0.25 / 8.0}, {}, exponential(8.0), PhaseFunction::rayleigh)};
  Physics p = make_physics(scene);
  bake(p, {256, 64, 32, 64});
  const double sky = ground_irradiance_table(p, 3).fetch_unit(1.0, 0.0).x;
  const double direct = p.transmittance_to_sun(p.scene.planet, 0.0, 1.0).x;
  EXPECT_NEAR(direct, std::exp(-0.25), 1e-3);
  EXPECT_NEAR(sky + direct, (5.0 - std::exp(-0.25)) / (4.0 + 3.0 * 0.25), 0.01);
}

TEST(GroundIrradiance, OfAUnitSkyIsPi) {
  Physics p = make_physics(vacuum());
  double irradiance = 0.0;
  double cosine = 0.0;
  double towards_sun = 0.0;
  for (unsigned int k = 0; k < physics::kGroundIrradianceDirections; ++k) {
    const auto ray = p.irradiance_ray(p.scene.planet, 0.6, k);
    EXPECT_GT(ray.mu, 0.0);
    EXPECT_EQ(ray.h, 0.0);
    EXPECT_EQ(ray.mu_sun, 0.6);
    irradiance += p.irradiance_weight();
    cosine += ray.mu * p.irradiance_weight();
    towards_sun += ray.nu * p.irradiance_weight();
  }
  EXPECT_NEAR(irradiance, kPi, 1e-12);
  EXPECT_NEAR(cosine / (2.0 * kPi / 3.0), 1.0, 0.004);             // of radiance mu; 8 midpoints
  EXPECT_NEAR(towards_sun / (2.0 * kPi / 3.0 * 0.6), 1.0, 0.004);  // of radiance nu: the mean direction is the zenith
}

// A white ground under a sky of radiance 1 has radiance 1; under the sun alone mu_sun / pi; at night none.
TEST(GroundIrradiance, LightsALambertianGround) {
  Scene scene = vacuum();
  scene.planet.ground_albedo = {1.0, 0.5, 0.0};
  Physics p = with_transmittance(scene);
  p.ground_irradiance_lut = filled_table(8, 1, [](double, double) { return vec3(kPi); });
  const vec3 night = p.ground_radiance(p.scene.planet, p.scene.sun, -0.5);
  EXPECT_NEAR(night.x, 1.0, 1e-12);
  EXPECT_NEAR(night.y, 0.5, 1e-12);
  EXPECT_EQ(night.z, 0.0);
  p.ground_irradiance_lut = filled_table(8, 1, [](double, double) { return vec3(0.0); });
  EXPECT_NEAR(p.ground_radiance(p.scene.planet, p.scene.sun, 0.6).x, 0.6 / kPi, 1e-12);
  EXPECT_EQ(p.ground_radiance(p.scene.planet, p.scene.sun, -0.01).x, 0.0);
  // And it is seen through the air between, at the ray's end.
  const auto down = p.ray_in_atmosphere(p.scene.planet, 10.0, -1.0, 0.6, -0.6);
  p.multiple_scattering_lut = filled_table(2, 2, [](double, double) { return vec3(0.0); });
  EXPECT_NEAR(p.march(p.scene.planet, p.scene.sun, down, 8, physics::kStepsUniform, 1.0).radiance.x, 0.6 / kPi, 1e-12);
}

}  // namespace
}  // namespace airlight::test
