#include "core/output/half_block.h"

#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "tests/output/files.h"

namespace airlight {
namespace {

std::vector<std::uint16_t> halves_of(const std::vector<float>& samples, ExrCounts& counts, std::size_t stride = 1) {
  std::vector<std::uint16_t> halves(samples.size() / stride);
  convert_to_half(samples.data(), stride, halves.size(), halves.data(), counts);
  return halves;
}

// Imath's conversion is the reference, on a sweep over every exponent and, with an odd step, every rounding case.
TEST(HalfBlock, AgreesWithImath) {
  std::vector<float> samples;
  for (std::uint64_t bits = 0; bits < (1ULL << 32); bits += 4099) {
    const float sample = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isnan(sample)) {
      samples.push_back(sample);
    }
  }
  for (std::uint32_t half_bits = 0; half_bits < 0x7bff; ++half_bits) {  // exact halves and the ties between them
    const float low = Imath::half(Imath::half::FromBits, static_cast<std::uint16_t>(half_bits));
    const float high = Imath::half(Imath::half::FromBits, static_cast<std::uint16_t>(half_bits + 1));
    samples.insert(samples.end(), {low, 0.5F * (low + high)});
  }
  ExrCounts counts;
  const std::vector<std::uint16_t> halves = halves_of(samples, counts);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Imath::half truth = std::clamp(samples[i], -65504.0F, 65504.0F);
    ASSERT_EQ(halves[i], truth.bits()) << samples[i];
  }
}

TEST(HalfBlock, CountsWhatAHalfCannotHold) {
  const std::vector<float> samples = {0.0F,   1.0F,  65504.0F, 65505.0F,   1e9F,  test::kInfinity, 6.2e-5F, 6.0e-5F,
                                      1e-10F, -1.0F, -1e9F,    test::kNan, -0.0F, -test::kInfinity};
  ExrCounts counts;
  const std::vector<std::uint16_t> halves = halves_of(samples, counts);
  EXPECT_EQ(counts.samples, samples.size());
  EXPECT_EQ(counts.clamped, 5U);  // 65505, 1e9, inf, -1e9, -inf
  EXPECT_EQ(counts.underflowed, 2U);
  EXPECT_EQ(counts.negative, 3U);
  EXPECT_EQ(counts.nan, 1U);
  EXPECT_EQ(halves[4], 0x7bff);  // 65504
  EXPECT_TRUE(Imath::half(Imath::half::FromBits, halves[11]).isNan());
}

TEST(HalfBlock, ReadsStridedSamplesAcrossBlocks) {
  std::vector<float> samples(4 * 3000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = i % 4 == 0 ? static_cast<float>(i / 4) / 2048.0F : test::kNan;
  }
  ExrCounts counts;
  const std::vector<std::uint16_t> halves = halves_of(samples, counts, 4);
  EXPECT_EQ(counts.nan, 0U);
  EXPECT_EQ(counts.samples, 3000U);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    ASSERT_EQ(halves[i], Imath::half(samples[4 * i]).bits()) << i;
  }
}

// Alpha, the fourth value of each pixel, is no light.
TEST(HalfBlock, SaysWhatHalvesWouldLose) {
  const auto loss = [](std::size_t place, float value, float typical = 1.0F) {
    RadianceImage image{7, 1, std::vector<float>(28, 1.0F)};
    image.rgba[place] = value;
    return half_loss(image, typical);
  };
  for (const std::size_t place : {0U, 1U, 14U, 26U}) {  // in wide vectors and behind them
    EXPECT_EQ(loss(place, 65504.0F), "") << place;
    EXPECT_NE(loss(place, 65536.0F), "") << place;
    EXPECT_EQ(loss(place, 1e-5F), "") << place;  // too dark to matter beside the others
    EXPECT_NE(loss(place, 1e-5F, 1e-4F), "") << place;
    EXPECT_EQ(loss(place, 0x1p-16F, 1e-4F), "") << place;
    EXPECT_EQ(loss(place, -1.0F, 1e-4F), "") << place;
  }
  EXPECT_EQ(loss(27, 1e-5F, 1e-4F), "");
  EXPECT_EQ(loss(27, 1e6F), "");
}

// Rows are counted on all cores.
TEST(HalfBlock, SaysWhatHalvesWouldLoseInAnyRow) {
  RadianceImage image{3, 100, std::vector<float>(1200, 1.0F)};
  for (std::size_t y = 0; y < 100; ++y) {
    image.rgba[12 * y + 4] = 1e6F;
    EXPECT_EQ(half_loss(image, 1.0), std::to_string(y + 1) + " samples are above 65504, the largest half");
  }
}

TEST(HalfBlock, FloatsAreCopiedAndCounted) {
  const std::vector<float> samples = {1e9F, 1e-9F, -1.0F, test::kNan};
  std::vector<std::uint16_t> words(2 * samples.size());
  ExrCounts counts;
  copy_floats(samples.data(), 1, samples.size(), words.data(), counts);
  EXPECT_EQ(std::memcmp(words.data(), samples.data(), sizeof(float) * samples.size()), 0);
  EXPECT_EQ(counts.samples, 4U);
  EXPECT_EQ(counts.clamped, 0U);
  EXPECT_EQ(counts.underflowed, 0U);
  EXPECT_EQ(counts.negative, 1U);
  EXPECT_EQ(counts.nan, 1U);
}

}  // namespace
}  // namespace airlight
