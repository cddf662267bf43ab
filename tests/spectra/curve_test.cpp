#include "core/spectra/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/spectra/data.h"

namespace airlight::test {
namespace {

TEST(Curves, AreLinearBetweenAndConstantOutside) {
  const Curve curve{.wavelengths = {400.0, 500.0, 700.0}, .values = {1.0, 3.0, 1.0}};
  EXPECT_DOUBLE_EQ(value_at(curve, 300.0), 1.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 400.0), 1.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 450.0), 2.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 600.0), 2.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 900.0), 1.0);
  EXPECT_DOUBLE_EQ(mean_over(curve, 400.0, 700.0), 2.0);
  EXPECT_DOUBLE_EQ(mean_over(curve, 300.0, 450.0), (100.0 * 1.0 + 50.0 * 1.5) / 150.0);
  EXPECT_DOUBLE_EQ(mean_over(curve, 800.0, 810.0), 1.0);
}

TEST(Curves, FollowAPowerLaw) {
  const Curve curve{.at_nm = 550.0, .value = 0.0114, .exponent = -1.3};
  EXPECT_DOUBLE_EQ(value_at(curve, 550.0), 0.0114);
  EXPECT_NEAR(value_at(curve, 440.0), 0.0114 * std::pow(0.8, -1.3), 1e-15);
  // The integral of x^-1.3 is -x^-0.3 / 0.3.
  const double exact = 0.0114 * std::pow(550.0, 1.3) * (std::pow(430.0, -0.3) - std::pow(440.0, -0.3)) / 0.3 / 10.0;
  EXPECT_NEAR(mean_over(curve, 430.0, 440.0) / exact, 1.0, 1e-8);
  EXPECT_DOUBLE_EQ(mean_over(constant_curve(0.3), 400.0, 700.0), 0.3);
}

// 0.1434 at 500 nm by layers of the US standard atmosphere (libRadtran's afglus): 8.44 km of air as dense as at the
// ground, the pressure there over g and the density, 1013.25 hPa / (9.8 m/s2 x 1.225 kg/m3).
TEST(Rayleigh, HasTheOpticalDepthOfTheStandardAtmosphere) {
  constexpr double kEquivalentHeight = 101.325 / (9.8 * 1.225);  // km
  EXPECT_NEAR(kEquivalentHeight * rayleigh_scattering(500.0), 0.1434, 0.0005);
  // Steeper than the fourth power, as the index of refraction grows into the blue.
  const double power = std::log(rayleigh_scattering(400.0) / rayleigh_scattering(700.0)) / std::log(700.0 / 400.0);
  EXPECT_GT(power, 4.05);
  EXPECT_LT(power, 4.13);
}

// 300 DU in the Chappuis band: 0.0406 at 602 nm (peak cross section 5.05e-25 m2, Serdyuchenko 2014).
TEST(Ozone, HasItsChappuisBand) {
  const double depth = 300.0 * kMoleculesPerDobsonUnit * value_at(ozone_cross_section(), 602.0);
  EXPECT_NEAR(depth, 0.0406, 0.001);
  EXPECT_LT(value_at(ozone_cross_section(), 420.0), 0.01 * value_at(ozone_cross_section(), 600.0));
}

TEST(BlackBody, FollowsPlanck) {
  EXPECT_DOUBLE_EQ(black_body(5772.0, 560.0), 1.0);
  // Wien: the peak of 5772 K lies at 502.0 nm.
  EXPECT_GT(black_body(5772.0, 502.0), black_body(5772.0, 495.0));
  EXPECT_GT(black_body(5772.0, 502.0), black_body(5772.0, 509.0));
}

}  // namespace
}  // namespace airlight::test
