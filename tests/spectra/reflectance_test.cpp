#include "core/spectra/reflectance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/spectra/data.h"

namespace airlight::test {
namespace {

std::array<double, kFineBands> by_bands(const std::array<Curve, 3>& primaries, const Rgb& colour) {
  std::array<double, kFineBands> sum{};
  for (std::size_t b = 0; b < sum.size(); ++b) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum[b] += colour[j] * value_at(primaries[j], 0.5 * (fine_bands()[b].low + fine_bands()[b].high));
    }
  }
  return sum;
}

// In sunlight a surface has its colour again, under each white. A grey one is grey at all wavelengths.
TEST(Reflectances, HaveTheirColourInSunlight) {
  for (const White white : {White::sun, White::d65, White::equal_energy}) {
    const auto primaries = reflectances_of_primaries(solar_irradiance(), white);
    const BandColours colours = band_colours(solar_irradiance(), white);
    const Rgb sun = sun_colour(colours);
    for (const Rgb& colour : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{0.3, 0.25, 0.1}}) {
      const Rgb seen = colour_of(colours, by_bands(primaries, colour));
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(seen[c] / sun[c], colour[c], 1e-9);
      }
    }
    for (const double value : by_bands(primaries, {0.4, 0.4, 0.4})) {
      EXPECT_NEAR(value, 0.4, 1e-9);
    }
  }
}

// No other reflectance of the colour has less slope: moved along any difference of the same colour, it grows.
TEST(Reflectances, AreTheSmoothest) {
  const auto primaries = reflectances_of_primaries(solar_irradiance(), White::sun);
  const BandColours colours = band_colours(solar_irradiance(), White::sun);
  const auto slope = [](const std::array<double, kFineBands>& x) {
    double sum = 0.0;
    for (std::size_t b = 1; b < x.size(); ++b) {
      sum += (x[b] - x[b - 1]) * (x[b] - x[b - 1]);
    }
    return sum;
  };
  const std::array<double, kFineBands> best = by_bands(primaries, {0.3, 0.2, 0.05});
  for (int k = 1; k < 6; ++k) {
    std::array<double, kFineBands> change{};
    for (std::size_t b = 0; b < change.size(); ++b) {
      change[b] = std::sin(0.37 * k * static_cast<double>(b) + k);
    }
    // A change without colour: the colour's share by the three primaries is subtracted.
    const std::array<double, kFineBands> same = by_bands(primaries, colour_of(colours, change));
    for (const double by : {-0.01, 0.01}) {
      std::array<double, kFineBands> other = best;
      for (std::size_t b = 0; b < other.size(); ++b) {
        other[b] += by * (change[b] - same[b]);
      }
      EXPECT_GT(slope(other), slope(best)) << k;
    }
  }
}

}  // namespace
}  // namespace airlight::test
