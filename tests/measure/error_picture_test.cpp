#include "core/measure/error_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight::measure {
namespace {

// Viridis is uniform in CAM02-UCS; in the simpler L* its lightness is straight within 2.
TEST(ColourMap, LightnessGrowsEvenly) {
  const double low = lightness(error_colour(0.0));
  const double high = lightness(error_colour(1.0));
  EXPECT_LT(low, 20.0);
  EXPECT_GT(high, 88.0);
  for (int i = 0; i <= 100; ++i) {
    const double fraction = i / 100.0;
    EXPECT_NEAR(lightness(error_colour(fraction)), low + fraction * (high - low), 2.0) << fraction;
  }
}

TEST(ColourMap, ClampsAndKeepsNanApart) {
  EXPECT_EQ(error_colour(-1.0), error_colour(0.0));
  EXPECT_EQ(error_colour(2.0), error_colour(1.0));
  for (int i = 0; i <= 255; ++i) EXPECT_NE(error_colour(i / 255.0), kNotANumber);
}

TEST(ErrorScale, ThreeDecadesBelowTheLargest) {
  const ErrorScale scale =
      scale_for(std::vector<float>{0.0F, 0.02F, std::numeric_limits<float>::infinity()}, false, {});
  EXPECT_NEAR(scale.high, 0.1, 1e-12);
  EXPECT_NEAR(scale.low, 1e-4, 1e-12);
  EXPECT_EQ(scale.fraction(0.0), 0.0);
  EXPECT_NEAR(scale.fraction(1e-3), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(scale.fraction(5.0), 1.0);
  EXPECT_NEAR(scale_for(std::vector<float>{0.1F}, false, {}).high, 0.1, 1e-12);  // not the decade above
  EXPECT_EQ(scale_for(std::vector<float>{0.1F}, false, 2.0).high, 2.0);
}

TEST(ErrorScale, StandardErrorsAreLinear) {
  const ErrorScale scale = scale_for(std::vector<float>{100.0F}, true, {});
  EXPECT_EQ(scale.fraction(0.0), 0.0);
  EXPECT_DOUBLE_EQ(scale.fraction(3.0), 0.5);
}

TEST(Heatmap, ShowsWhereAndHowMuch) {
  std::vector<float> errors(600 * 10, 1e-5F);
  errors[600 * 4 + 123] = 0.01F;
  errors[600 * 9 + 599] = std::numeric_limits<float>::infinity();
  const ErrorScale scale = scale_for(errors, false, {});
  const Raster map = draw_heatmap(errors, {600, 10}, scale);
  ASSERT_EQ(map.width(), 600);  // not enlarged: one pixel each, below the title
  const int top = (kGlyphHeight + 8);
  EXPECT_EQ(map.at(123, top + 4), error_colour(1.0));
  EXPECT_EQ(map.at(122, top + 4), error_colour(0.0));
  EXPECT_EQ(map.at(599, top + 9), kNotANumber);
  EXPECT_GT(map.height(), top + 10 + 2 * kGlyphHeight);
}

TEST(Heatmap, SmallPicturesAreEnlarged) {
  const std::vector<float> errors = {1.0F, 0.0F};
  const Raster map = draw_heatmap(errors, {2, 1}, scale_for(errors, false, {}));
  ASSERT_EQ(map.width(), 480);
  const int middle = map.height() / 2;
  EXPECT_EQ(map.at(10, middle), error_colour(1.0));
  EXPECT_EQ(map.at(470, middle), error_colour(0.0));
}

// The bar runs through the whole map from left to right, and numbers stand below it.
TEST(Heatmap, DrawsItsScale) {
  const std::vector<float> errors(480 * 4, 0.5F);
  const Raster map = draw_heatmap(errors, {480, 4}, scale_for(errors, false, {}));
  const int bar = kGlyphHeight + 8 + 4 + 5;
  EXPECT_EQ(map.at(4, bar), error_colour(0.0));
  double last = -1.0;
  int brightest = 0;
  for (int x = 4; map.at(x, bar) != map.at(0, bar); ++x) {
    const double now = lightness(map.at(x, bar));
    EXPECT_GE(now, last - 0.6);
    last = now;
    brightest = x;
  }
  EXPECT_GT(brightest, 380);
  EXPECT_GT(last, 88.0);
  int ink = 0;
  for (int y = bar + 8; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) ink += map.at(x, y)[0] > 200 ? 1 : 0;
  }
  EXPECT_GT(ink, 100);
}

TEST(SideBySide, ShowsBothWithOneExposure) {
  const std::vector<float> dark(480 * 2, 0.5F);
  const std::vector<float> bright(480 * 2, 1.0F);
  const std::vector<float> errors(480 * 2, 0.5F);
  const Raster picture =
      draw_side_by_side({dark, dark, dark}, {bright, bright, bright}, errors, {480, 2}, scale_for(errors, false, {}));
  const int row = kGlyphHeight + 8;
  const Colour a = picture.at(0, row);
  const Colour b = picture.at(484, row);
  EXPECT_LT(a[0], b[0]);
  EXPECT_EQ(a[0], display_code(0.6));
  EXPECT_EQ(b[1], display_code(1.2));
  EXPECT_EQ(picture.at(968, row), error_colour(scale_for(errors, false, {}).fraction(0.5)));
}

TEST(Raster, WritesLetters) {
  Raster raster(12, 7, {0, 0, 0});
  raster.write(0, 0, 1, {9, 9, 9}, "1");
  // A one: its stem is the middle column of five.
  for (int y = 0; y < 7; ++y) EXPECT_EQ(raster.at(2, y)[0], 9) << y;
  EXPECT_EQ(raster.at(0, 0)[0], 0);
  raster.fill({0, 0, 12, 7}, {0, 0, 0});
  raster.write(0, 0, 1, {9, 9, 9}, "l");  // its stem stands at the left, its foot below
  EXPECT_EQ(raster.at(0, 0)[0], 9);
  EXPECT_EQ(raster.at(4, 0)[0], 0);
  EXPECT_EQ(raster.at(4, 6)[0], 9);
  raster.write(6, 0, 1, {9, 9, 9}, "\t");
  EXPECT_EQ(raster.at(6, 0)[0], 9);  // unknown: a box
  EXPECT_EQ(raster.at(7, 1)[0], 0);
}

TEST(Raster, LeavesOutWhatIsOutside) {
  Raster raster(3, 3, {1, 1, 1});
  raster.fill({-5, -5, 20, 6}, {7, 7, 7});
  EXPECT_EQ(raster.at(2, 0)[0], 7);
  EXPECT_EQ(raster.at(2, 1)[0], 1);
}

}  // namespace
}  // namespace airlight::measure
