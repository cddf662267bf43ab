#include "core/render/sky_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace airlight::test {
namespace {

using std::numbers::pi;

// Tregenza's 145 patches, and Reinhart's.
TEST(SkyPatches, AreThoseOfDaylightPrograms) {
  const std::array<std::size_t, 4> counts{146, 578, 1298, 2306};
  for (int factor = 1; factor <= kMostSkyDivisions; ++factor) {
    const SkyPatches patches(factor);
    ASSERT_EQ(patches.count(), counts.at(static_cast<std::size_t>(factor - 1)));
    double sum = 0.0;
    for (std::size_t patch = 1; patch < patches.count(); ++patch) {
      sum += patches.solid_angle(patch);
      const auto [x, y, z] = patches.centre(patch);
      EXPECT_EQ(patches.at(std::asin(std::min(1.0, y)), std::atan2(x, -z)), patch);
    }
    EXPECT_NEAR(sum, 2.0 * pi, 1e-9);
  }
  const SkyPatches patches(1);
  EXPECT_EQ(patches.at(0.05, 0.0), 1U);                // north
  EXPECT_EQ(patches.at(0.05, 0.5 * pi + 0.01), 9U);    // east: patches of 12 degrees
  EXPECT_EQ(patches.at(0.05, -0.5 * pi + 0.11), 24U);  // west
  EXPECT_EQ(patches.at(0.5 * pi, 1.0), 145U);
  EXPECT_EQ(patches.at(-1e-9, 1.0), 0U);
}

// Level ground gets the light of a sun from its patches, and the light comes from the sun's side.
TEST(SkyPatches, ShareASun) {
  for (const int factor : {1, 3}) {
    const SkyPatches patches(factor);
    for (const double elevation : {0.02, 0.13, 0.3, 1.1, 1.5, 0.5 * pi}) {
      for (const double azimuth : {-3.0, 0.0, 0.07, 2.0, 6.28}) {
        double sum = 0.0;
        double level = 0.0;
        double along = 0.0;
        for (const auto& [patch, share] : patches.around(elevation, azimuth)) {
          const auto [x, y, z] = patches.centre(patch);
          EXPECT_GE(share, 0.0);
          sum += share;
          level += share * y;
          along += share * (x * std::sin(azimuth) - z * std::cos(azimuth));
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
        const double lowest = std::asin(patches.centre(1)[1]);
        EXPECT_NEAR(level, std::sin(std::max(elevation, lowest)), 1e-9) << elevation << " " << azimuth;
        EXPECT_NEAR(along, std::cos(elevation), 0.05) << elevation << " " << azimuth;
      }
    }
  }
}

// Directions in a picture are where the patches have them, and no light is lost.
TEST(SkyPatches, AverageAPicture) {
  constexpr int kRows = 48;
  RadianceImage picture{2 * kRows, kRows, {}};
  const auto light = [](double elevation, double azimuth) {
    return 2.0 + std::cos(elevation) * std::sin(azimuth) + 0.5 * std::sin(elevation);
  };
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < 2 * kRows; ++x) {
      const double value = light(pi * (0.5 - (y + 0.5) / kRows), pi * ((x + 0.5) / kRows - 1.0));
      picture.rgba.insert(picture.rgba.end(), {static_cast<float>(value), 0.0F, 1.0F, 1.0F});
    }
  }
  const SkyPatches patches(2);
  const auto means = PatchMeans(patches, picture.width, picture.height).of(picture);
  double flux = 0.0;
  for (std::size_t patch = 1; patch < patches.count(); ++patch) {
    const auto [x, y, z] = patches.centre(patch);
    EXPECT_NEAR(means[patch][0], light(std::asin(std::min(1.0, y)), std::atan2(x, -z)), 0.02) << patch;
    EXPECT_NEAR(means[patch][2], 1.0, 1e-12);
    flux += means[patch][0] * patches.solid_angle(patch);
  }
  EXPECT_NEAR(flux, 2.0 * pi * 2.25, 0.01);
  EXPECT_NEAR(means[0][0], 1.75, 0.01);  // the mean below the horizon
}

}  // namespace
}  // namespace airlight::test
