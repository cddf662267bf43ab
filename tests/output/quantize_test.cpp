#include "core/output/quantize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/output/files.h"

namespace airlight {
namespace {

RadianceImage flat(int width, int height, float value) {
  return {width, height,
          std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value)};
}

double mean_of(const std::vector<std::uint8_t>& bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), 0.0) / static_cast<double>(bytes.size());
}

TEST(Quantize, SixteenBitsAreRounded) {
  RadianceImage image = flat(2, 1, 0.0F);
  image.rgba = {0.5F, 1.0F, -0.1F, 0.25F, test::kNan, test::kInfinity, 1.5F, 1.0F};
  const PixelImage pixels = quantize(image, {.bits = 16, .dither = true, .alpha = true});
  EXPECT_EQ(pixels.words, (std::vector<std::uint16_t>{32768, 65535, 0, 16384, 0, 65535, 65535, 65535}));
}

TEST(Quantize, EightBitsWithoutDitherAreRounded) {
  RadianceImage image = flat(2, 1, 0.0F);
  image.rgba = {0.5F, 1.0F, -0.1F, 1.0F, test::kNan, test::kInfinity, 0.4980F, 0.0F};
  const PixelImage pixels = quantize(image, {.bits = 8, .dither = false, .alpha = false});
  EXPECT_EQ(pixels.channels, 3);
  EXPECT_EQ(pixels.bytes, (std::vector<std::uint8_t>{128, 255, 0, 0, 255, 127}));
}

TEST(Quantize, AlphaIsNotDithered) {
  RadianceImage image = flat(64, 64, 0.5F);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = i % 8 == 3 ? 0.0F : 1.0F;
  }
  const PixelImage pixels = quantize(image, {.bits = 8, .dither = true, .alpha = true});
  ASSERT_EQ(pixels.channels, 4);
  for (std::size_t i = 3; i < pixels.bytes.size(); i += 4) {
    ASSERT_EQ(pixels.bytes[i], i % 8 == 3 ? 0 : 255);
  }
}

// Zero mean: a flat grey between two codes keeps its value on average, near black and white too.
TEST(Dither, KeepsTheMeanOfEveryChannel) {
  for (const double code : {0.1, 0.5, 0.9, 1.05, 1.5, 7.25, 100.0, 127.75, 200.4, 253.3, 254.2, 254.9}) {
    const PixelImage pixels = quantize(flat(128, 128, static_cast<float>(code / 255)), {});
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<std::uint8_t> channel;
      for (std::size_t i = c; i < pixels.bytes.size(); i += 3) {
        channel.push_back(pixels.bytes[i]);
      }
      // 16384 thresholds of 256 levels, evenly spread: random ones would be off by 0.004.
      EXPECT_NEAR(mean_of(channel), code, 0.003) << code << ", channel " << c;
    }
  }
}

// Nearly blue noise: even blocks of 8 x 8 pixels keep the mean; random thresholds would miss it by 0.06 (one sigma).
TEST(Dither, KeepsTheMeanOfSmallPatches) {
  const PixelImage pixels = quantize(flat(128, 128, 100.4F / 255), {});
  double worst = 0;
  for (std::size_t y = 0; y < 128; y += 8) {
    for (std::size_t x = 0; x < 128; x += 8) {
      double sum = 0;
      for (std::size_t k = 0; k < 64; ++k) {
        sum += pixels.bytes[3 * ((y + k / 8) * 128 + x + k % 8)];
      }
      worst = std::max(worst, std::fabs(sum / 64 - 100.4));
    }
  }
  EXPECT_LT(worst, 0.08);
}

TEST(Dither, LeavesPureBlackAndWhiteAlone) {
  for (const float value : {0.0F, 1.0F, -1.0F, 2.0F, test::kNan}) {
    const PixelImage pixels = quantize(flat(256, 64, value), {});
    const std::uint8_t expected = value >= 1.0F ? 255 : 0;
    EXPECT_TRUE(std::all_of(pixels.bytes.begin(), pixels.bytes.end(), [&](std::uint8_t b) { return b == expected; }))
        << value;
  }
}

TEST(Dither, IsTheSameEveryTimeAndWithinOneCode) {
  const RadianceImage image = flat(100, 50, 0.3333F);
  const PixelImage once = quantize(image, {});
  EXPECT_EQ(once.bytes, quantize(image, {}).bytes);
  for (const std::uint8_t byte : once.bytes) {
    ASSERT_NEAR(byte, 0.3333 * 255, 1.5);
  }
}

// A ramp of 4 codes over 1024 pixels: rounding makes flat bands 256 wide, dither leaves no run of equal pixels.
TEST(Dither, BreaksUpBands) {
  RadianceImage ramp = flat(1024, 16, 0.0F);
  for (std::size_t i = 0; i < ramp.rgba.size(); ++i) {
    ramp.rgba[i] = static_cast<float>((60.0 + static_cast<double>(i / 4 % 1024) / 256) / 255);
  }
  const auto longest_run = [&](bool dither) {
    const PixelImage pixels = quantize(ramp, {.bits = 8, .dither = dither, .alpha = false});
    std::size_t longest = 0, run = 0;
    for (std::size_t x = 1; x < 1024; ++x) {
      run = pixels.bytes[3 * x] == pixels.bytes[3 * (x - 1)] ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    return longest;
  };
  EXPECT_GT(longest_run(false), 200U);
  EXPECT_LT(longest_run(true), 10U);
}

}  // namespace
}  // namespace airlight
