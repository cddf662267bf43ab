// Colours by the eye's rods.

#include "core/output/rods.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/srgb.h"

namespace airlight {
namespace {

RadianceImage pixel(float red, float green, float blue) {
  return {1, 1, {red, green, blue, 0.5F}};
}

double luminance(const RadianceImage& image) {
  return bt709_luminance(double{image.rgba[0]}, double{image.rgba[1]}, double{image.rgba[2]});
}

// Ratio of scotopic to photopic light of illuminant A over that of D65: 1.41 / 2.47 (CIE). The colour of A in linear
// Rec.709 for a luminance of 1, by x 0.44757 and y 0.40745.
TEST(Rods, SeeLittleOfTungstensLight) {
  const double x = 0.44757 / 0.40745;
  const double z = (1.0 - 0.44757 - 0.40745) / 0.40745;
  const double red = 3.24045 * x - 1.53714 - 0.49853 * z;
  const double green = -0.96927 * x + 1.87601 + 0.04156 * z;
  const double blue = 0.05564 * x - 0.20403 + 1.05723 * z;
  EXPECT_NEAR(rods_luminance(red, green, blue), 1.41 / 2.47, 0.03);
  EXPECT_NEAR(rods_luminance(1.0, 1.0, 1.0), 1.0, 1e-3);
}

TEST(Rods, LeaveWhatIsBright) {
  RadianceImage image = pixel(2.0F, 3.5F, 4.0F);
  const RadianceImage before = image;
  see_by_rods(image, 1.0);
  EXPECT_EQ(image.rgba, before.rgba);
  RadianceImage in_lux = pixel(2e-5F, 3.5e-5F, 4e-5F);  // the same light in another unit
  see_by_rods(in_lux, 1e5);
  EXPECT_EQ(in_lux.rgba, pixel(2e-5F, 3.5e-5F, 4e-5F).rgba);
}

TEST(Rods, KeepGreyAsBrightAndMakeItBlue) {
  for (const float level : {1.0F, 0.1F, 1e-3F, 1e-6F}) {
    RadianceImage image = pixel(level, level, level);
    see_by_rods(image, 1.0);
    EXPECT_NEAR(luminance(image) / static_cast<double>(level), 1.0, 1e-3);
    EXPECT_GT(image.rgba[2], image.rgba[0]);
    EXPECT_EQ(image.rgba[3], 0.5F);
  }
}

// Red fades before blue (Purkinje), the more so the darker it is.
TEST(Rods, SeeBlueAsBrighterThanRed) {
  double before = 1e9;
  for (const float level : {2.0F, 0.3F, 0.03F, 3e-3F}) {
    RadianceImage red = pixel(level / 0.2126F, 0.0F, 0.0F);
    RadianceImage blue = pixel(0.0F, 0.0F, level / 0.0722F);
    see_by_rods(red, 1.0);
    see_by_rods(blue, 1.0);
    EXPECT_LT(luminance(red) / luminance(blue), before);
    before = luminance(red) / luminance(blue);
  }
  EXPECT_LT(before, 0.2);
}

}  // namespace
}  // namespace airlight
