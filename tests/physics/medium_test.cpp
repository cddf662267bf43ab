// Densities over altitude, and the coefficients that follow.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

// Density of a scene's only medium.
double density_at(const Density& density, double h) {
  Scene scene = vacuum();
  scene.media = {medium("only", {1.0, 1.0, 1.0}, {}, density)};
  Physics p = make_physics(scene);
  return p.density(p.density_profile(0), p.medium(0), h);
}

TEST(Density, FollowsItsClosedForm) {
  for (const double h : {0.0, 1e-6, 0.5, 7.9, 8.0, 24.999, 25.0, 39.9, 40.1, 100.0, 1e4}) {
    EXPECT_DOUBLE_EQ(density_at(exponential(8.0), h), std::exp(-h / 8.0)) << h;
    EXPECT_DOUBLE_EQ(density_at(tent(25.0, 15.0), h), std::max(0.0, 1.0 - std::abs(h - 25.0) / 15.0)) << h;
    const double x = (12.0 - h) / 4.0;
    EXPECT_DOUBLE_EQ(density_at(lorentzian(20.0, 12.0, 4.0), h), std::exp(-h / 20.0) / (1.0 + x * x)) << h;
    EXPECT_EQ(density_at(constant(8.0), h), h <= 8.0 ? 1.0 : 0.0) << h;
    EXPECT_DOUBLE_EQ(density_at(height_fog(8.0, 2.0), h), h <= 8.0 ? 1.0 : std::exp(-(h - 8.0) / 2.0)) << h;
  }
}

// The mean over a step against the integral in altitude: below the base, across it, above it, down, level, and many
// scale heights high.
TEST(Density, OfAFogOverAStepIsTheIntegral) {
  Scene scene = vacuum();
  scene.media = {medium("fog", {1.0, 1.0, 1.0}, {}, height_fog(0.3, 0.05))};
  Physics p = make_physics(scene);
  const auto density = [&](double h) { return p.density(p.density_profile(0), p.medium(0), h); };
  for (const double h : {0.05, 0.2, 0.28, 0.3, 0.31, 0.5, 1.5}) {
    for (const double rise : {0.0, 1e-14, 1e-9, 1e-4, 0.015, 0.03, 0.1, -0.1, 0.4, 2.5}) {
      const double low = h - 0.5 * std::abs(rise);
      const double high = h + 0.5 * std::abs(rise);
      // Beyond its kink the integrand is smooth.
      const double kink = std::clamp(0.3, low, high);
      const double sum = integral(density, low, kink, 64) + integral(density, kink, high, 64);
      const double truth = std::abs(rise) < 1e-12 ? density(h) : sum / std::abs(rise);
      EXPECT_NEAR(p.step_density(p.density_profile(0), p.medium(0), h, rise), truth, 1e-6 * truth + 1e-15)
          << h << ", " << rise;
    }
  }
}

// Along whole rays on the sphere a march of few steps has the fog's optical depth, even along level rays.
TEST(OpticalDepth, OfAFogIsHeldByFewSteps) {
  Scene scene = vacuum();
  scene.media = {medium("fog", {1.0, 1.0, 1.0}, {}, height_fog(0.1, 0.05))};
  Physics p = make_physics(scene);
  const double radius = p.scene.planet.ground_radius;
  for (const double h : {0.001, 0.12, 0.4}) {
    for (const double mu : {1.0, 0.3, 0.02, 0.0}) {
      const double r = radius + h;
      const auto along = [&](double t) {
        const double q = t * (2.0 * r * mu + t);
        return p.extinction_at(h + q / (std::sqrt(r * r + q) + r)).x;
      };
      const double a = r * mu;
      const double c = (0.1 - h) * (2.0 * radius + h + 0.1);
      const double kink = c > 0.0 ? c / (a + std::sqrt(a * a + c)) : 0.0;
      const double end = p.distance_to_top(p.scene.planet, h, mu);
      const double far = std::min(end, kink + 400.0);
      const double truth = integral(along, 0.0, kink, 2000) + integral(along, kink, far, 20000);
      EXPECT_NEAR(p.optical_depth_to_top(p.scene.planet, h, mu, physics::kTransmittanceSteps).x / truth, 1.0, 0.006)
          << h << ", " << mu;
    }
  }
}

TEST(Density, IsOneAtItsReference) {
  EXPECT_EQ(density_at(exponential(8.0), 0.0), 1.0);
  EXPECT_EQ(density_at(tent(25.0, 15.0), 25.0), 1.0);
  EXPECT_EQ(density_at(constant(8.0), 0.0), 1.0);
  EXPECT_DOUBLE_EQ(density_at(lorentzian(1e300, 12.0, 4.0), 12.0), 1.0);
}

TEST(Density, LayersAreLinearBetweenTheirPointsAndConstantOutside) {
  const Density list = layers({{1.0, 0.5}, {3.0, 1.0}, {3.5, 0.0}, {10.0, 0.25}});
  EXPECT_EQ(density_at(list, 0.0), 0.5);
  EXPECT_EQ(density_at(list, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(density_at(list, 1.5), 0.625);
  EXPECT_DOUBLE_EQ(density_at(list, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(density_at(list, 3.25), 0.5);
  EXPECT_DOUBLE_EQ(density_at(list, 3.5), 0.0);
  EXPECT_DOUBLE_EQ(density_at(list, 3.5 + 1.3), 0.05);
  EXPECT_EQ(density_at(list, 10.0), 0.25);
  EXPECT_EQ(density_at(list, 99.0), 0.25);
  EXPECT_EQ(density_at(layers({{5.0, 0.7}}), 0.0), 0.7);
  EXPECT_EQ(density_at(layers({{5.0, 0.7}}), 50.0), 0.7);
}

// Each medium of a scene reads its own layers, not those of the medium before it.
TEST(Density, LayersOfSeveralMediaStandApart) {
  Scene scene = vacuum();
  scene.media = {medium("a", {}, {}, layers({{0.0, 1.0}, {10.0, 0.0}})), medium("b", {}, {}, exponential(8.0)),
                 medium("c", {}, {}, layers({{0.0, 0.0}, {20.0, 2.0}}))};
  Physics p = make_physics(scene);
  EXPECT_DOUBLE_EQ(p.density(p.density_profile(0), p.medium(0), 5.0), 0.5);
  EXPECT_DOUBLE_EQ(p.density(p.density_profile(1), p.medium(1), 8.0), std::exp(-1.0));
  EXPECT_DOUBLE_EQ(p.density(p.density_profile(2), p.medium(2), 5.0), 0.5);
}

TEST(Density, OfAColumnAddsUp) {
  const auto column = [](const Density& density, int panels) {
    return integral([&](double h) { return density_at(density, h); }, 0.0, 100.0, panels);
  };
  EXPECT_NEAR(column(exponential(8.0), 100), 8.0 * (1.0 - std::exp(-12.5)), 1e-12);
  EXPECT_NEAR(column(tent(25.0, 15.0), 100), 15.0, 1e-12);
  EXPECT_NEAR(column(constant(8.0), 100), 8.0, 1e-12);
  EXPECT_NEAR(column(layers({{0.0, 1.0}, {2.0, 0.5}, {10.0, 0.0}}), 100), 1.5 + 2.0, 1e-12);
}

// Loops over eight media are unrolled calls: each medium must count, with its own coefficients and phase.
TEST(Air, AddsUpItsMediaEachWithItsOwnPhase) {
  for (std::size_t count = 0; count <= 8; ++count) {
    Scene scene = vacuum();
    vec3 scattering;
    vec3 extinction;
    double phase_scattering = 0.0;
    Physics formulas{};
    for (std::size_t i = 0; i < count; ++i) {
      const double s = 0.1 * static_cast<double>(i + 1);
      const double g = 0.1 * static_cast<double>(i) - 0.35;
      scene.media.push_back(medium("m" + std::to_string(i), {s, 2.0 * s, 3.0 * s}, {0.5 * s, 0.0, s},
                                   exponential(static_cast<double>(i + 1)), PhaseFunction::henyey_greenstein, g));
      const double d = std::exp(-2.0 / static_cast<double>(i + 1));
      scattering = scattering + vec3(s, 2.0 * s, 3.0 * s) * d;
      extinction = extinction + vec3(1.5 * s, 2.0 * s, 4.0 * s) * d;
      phase_scattering += s * d * formulas.phase_henyey_greenstein(g, 0.3);
    }
    Physics p = make_physics(scene);
    const auto air = p.air_at(2.0, p.phases(0.3));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(channel(air.scattering, c), channel(scattering, c), 1e-14) << count;
      EXPECT_NEAR(channel(air.extinction, c), channel(extinction, c), 1e-14) << count;
      EXPECT_EQ(channel(p.extinction_at(2.0), c), channel(air.extinction, c));
    }
    EXPECT_NEAR(air.phase_scattering.x, phase_scattering, 1e-14) << count;
  }
}

TEST(OpticalDepth, OfAVerticalColumnIsItsClosedForm) {
  Scene scene = vacuum();
  scene.media = {medium("air", {0.02, 0.01, 0.0}, {0.01, 0.0, 0.03}, exponential(8.0))};
  Physics p = make_physics(scene);
  for (const double h : {0.0, 1.0, 30.0, 99.0}) {
    const double column = 8.0 * (std::exp(-h / 8.0) - std::exp(-100.0 / 8.0));
    const vec3 depth = p.optical_depth_to_top(p.scene.planet, h, 1.0, 4096);
    EXPECT_NEAR(depth.x / (0.03 * column), 1.0, 3e-7) << h;  // 3e-7: midpoints, error as 1/n^2
    EXPECT_NEAR(depth.y / (0.01 * column), 1.0, 3e-7) << h;
    EXPECT_NEAR(depth.z / (0.03 * column), 1.0, 3e-7) << h;
    // The table's own 40 steps: a right-endpoint rule is 4 to 15 % off here.
    EXPECT_NEAR(p.optical_depth_to_top(p.scene.planet, h, 1.0, physics::kTransmittanceSteps).x / (0.03 * column), 1.0,
                0.003)
        << h;
  }
}

// Against an integral along the ray in Cartesian coordinates, in all directions, upward and down past the horizon.
TEST(OpticalDepth, OfASlantedColumnIsTheIntegralOfExtinction) {
  Physics p = make_physics(every_kind());
  const double radius = p.scene.planet.ground_radius;
  const double top = radius + p.scene.planet.atmosphere_height;
  for (const double h : {0.0, 0.5, 10.0, 60.0}) {
    const double horizon = p.horizon_mu(p.scene.planet, h);
    for (const double mu : {1.0, 0.5, 0.1, 0.01, 0.0, 0.5 * horizon, horizon}) {
      const double r = radius + h;
      const double length = -r * mu + std::sqrt(r * r * mu * mu + (top - r) * (top + r));
      const double depth = integral(
          [&](double t) {
            const double altitude = std::hypot(r * std::sqrt(1.0 - mu * mu), r * mu + t) - radius;
            return p.extinction_at(std::max(altitude, 0.0)).x;
          },
          0.0, length, 4000);
      // 1e-3: a midpoint rule does not resolve where `constant` ends within its step.
      EXPECT_NEAR(p.optical_depth_to_top(p.scene.planet, h, mu, 4096).x / depth, 1.0, 1e-3) << h << ", " << mu;
      EXPECT_NEAR(p.optical_depth_to_top(p.scene.planet, h, mu, physics::kTransmittanceSteps).x / depth, 1.0, 0.05)
          << h << ", " << mu;
    }
  }
}

}  // namespace
}  // namespace airlight::test
