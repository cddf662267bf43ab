// The moon's light: its formula against its table, against another's magnitudes, and the smoothing.

#include "core/spectra/moonlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

namespace airlight {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFullDisc = 6.4236e-5 / std::numbers::pi;  // irradiance of a disc of reflectance 1 over the sun's

TEST(Moonlight, IsWithinFivePercentOfEachBand) {
  for (const double phase : {-90.0, -45.0, 5.0, 20.0, 45.0, 70.0, 90.0}) {
    const Curve light = moonlight(phase * kDegree, kMeanMoonDistance);
    for (std::size_t band = 0; band < kLunarBands; ++band) {
      const double truth = lunar_reflectance(band, phase * kDegree) * kFullDisc;
      EXPECT_NEAR(value_at(light, lunar_band(band)) / truth, 1.0, 0.05) << lunar_band(band) << " nm at " << phase;
    }
  }
}

// Smoothing moves no light: the mean over the bands is that of the formula to 2 %.
TEST(Moonlight, IsInTheMeanThatOfItsFormula) {
  for (const double phase : {-90.0, -45.0, 5.0, 20.0, 45.0, 70.0, 90.0}) {
    const Curve light = moonlight(phase * kDegree, kMeanMoonDistance);
    double sum = 0.0;
    for (std::size_t band = 0; band < kLunarBands; ++band) {
      sum += value_at(light, lunar_band(band)) / (lunar_reflectance(band, phase * kDegree) * kFullDisc) / kLunarBands;
    }
    EXPECT_NEAR(sum, 1.0, 0.02) << phase;
  }
}

// The published table by the formula as it is written there, where a copy of the table is.
TEST(Moonlight, IsThatOfThePublishedTable) {
  std::ifstream file("../shared/night/moon-rolo.csv");
  if (!file) {
    file.open(AIRLIGHT_SOURCE_DIR "/../shared/night/moon-rolo.csv");
  }
  if (!file) {
    GTEST_SKIP() << "../shared/night/moon-rolo.csv is not there";
  }
  std::string line;
  std::size_t band = 0;
  while (std::getline(file, line) && band < kLunarBands) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream values(line);
    std::array<double, 11> v{};
    std::ranges::for_each(v, [&](double& value) { values >> value; });
    if (!values) {
      continue;
    }
    EXPECT_NEAR(lunar_band(band), v[0], 1e-6);
    for (const double phase : {5.0, 20.0, 45.0, 90.0}) {
      const double g = phase * kDegree;
      const double log_a = v[1] + g * (v[2] + g * (v[3] + g * v[4])) + v[5] * g + v[6] * std::pow(g, 3) +
                           v[7] * std::pow(g, 5) + v[8] * std::exp(-phase / 4.06054) +
                           v[9] * std::exp(-phase / 12.8802) + v[10] * std::cos((phase + 30.5858) / 16.7498);
      EXPECT_NEAR(lunar_reflectance(band, g) / std::exp(log_a), 1.0, 1e-4) << v[0] << " nm at " << phase;
    }
    ++band;
  }
  EXPECT_EQ(band, kLunarBands);
}

// Logarithms of the reflectance at 549.1 nm, worked out by hand from table 4 for phases of 10 and 60 degrees: the first
// sum takes radians, the exponentials degrees.
TEST(Moonlight, TakesRadiansInThePolynomialAndDegreesInTheExponentials) {
  const double g = 10.0 * kDegree;
  const double polynomial = -2.10782 - 1.66736 * g + 0.41697 * g * g - 0.22026 * g * g * g;
  const double odd = 0.03451 * g + 0.01452 * g * g * g - 0.00517 * std::pow(g, 5);
  const double surge = 0.36814 * std::exp(-10.0 / 4.06054) - 0.09815 * std::exp(-10.0 / 12.8802);
  EXPECT_NEAR(std::log(lunar_reflectance(10, g)), polynomial + odd + surge, 1e-4);
}

// Allen, Astrophysical Quantities: 0.026 a + 4e-9 a^4 magnitudes from full to the phase a in degrees, the mean of
// waxing and waning. It has no opposition surge, so the count begins at 10 degrees.
TEST(Moonlight, FadesAsItsMagnitudesSay) {
  const auto magnitude = [](double degrees) {
    const double both = value_at(moonlight(degrees * kDegree, kMeanMoonDistance), 549.0) +
                        value_at(moonlight(-degrees * kDegree, kMeanMoonDistance), 549.0);
    return -2.5 * std::log10(both);
  };
  const auto allen = [](double a) { return 0.026 * a + 4e-9 * std::pow(a, 4); };
  for (const double degrees : {40.0, 60.0, 90.0, 120.0, 150.0}) {
    EXPECT_NEAR(magnitude(degrees) - magnitude(10.0), allen(degrees) - allen(10.0), 0.2) << degrees;
  }
}

TEST(Moonlight, GoesWithTheSquareOfTheDistance) {
  const double near = value_at(moonlight(0.5, 0.5 * kMeanMoonDistance), 550.0);
  EXPECT_NEAR(near / value_at(moonlight(0.5, kMeanMoonDistance), 550.0), 4.0, 1e-12);
}

TEST(Moonlight, IsRedderThanTheSuns) {
  const Curve light = moonlight(0.5, kMeanMoonDistance);
  EXPECT_GT(value_at(light, 650.0), 1.25 * value_at(light, 450.0));
}

// A thin crescent's earthshine is about 10 000 times fainter than sunlight on the moon: 4 to 5 magnitudes a square arc
// second below that of a half moon's lit side and more below the crescent's limb.
TEST(Earthshine, IsFullWhenTheMoonIsNew) {
  EXPECT_EQ(earthshine(0.0), 0.0);
  const double new_moon = earthshine(std::numbers::pi) * lunar_reflectance(10, std::numbers::pi);
  EXPECT_NEAR(new_moon / lunar_reflectance(10, 0.0), 0.434 * std::pow(6371.0 / 384400.0, 2), 1e-9);
}

}  // namespace
}  // namespace airlight
