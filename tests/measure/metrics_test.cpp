#include "core/measure/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace airlight::measure {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Metrics, RelativeErrorIsOfTheReference) {
  const std::vector<float> a = {1.5F, 2.0F, 0.0F};
  const std::vector<float> b = {1.0F, -4.0F, 1.0F};
  const std::vector<float> errors = relative_errors(a, b);
  EXPECT_FLOAT_EQ(errors[0], 0.5F);
  EXPECT_FLOAT_EQ(errors[1], 1.5F);
  EXPECT_FLOAT_EQ(errors[2], 1.0F);
}

// mean|b| = 1000 / 4 = 250, so the floor is 0.25: |0.001 - 0| / 0.25.
TEST(Metrics, FloorIsAThousandthOfTheMean) {
  const std::vector<float> a = {0.001F, 1000.0F, 0.0F, 0.125F};
  const std::vector<float> b = {0.0F, 1000.0F, 0.0F, 0.0F};
  const std::vector<float> errors = relative_errors(a, b);
  EXPECT_FLOAT_EQ(errors[0], 0.004F);
  EXPECT_EQ(errors[1], 0.0F);
  EXPECT_EQ(errors[2], 0.0F);
  EXPECT_FLOAT_EQ(errors[3], 0.5F);
}

TEST(Metrics, BlackReferenceGivesInfiniteErrorWhereAnythingIsThere) {
  const std::vector<float> errors = relative_errors(std::vector<float>{0.0F, 1.0F}, std::vector<float>{0.0F, 0.0F});
  EXPECT_EQ(errors[0], 0.0F);
  EXPECT_EQ(errors[1], kInf);
}

TEST(Metrics, PercentilesAreOfNearestRank) {
  std::vector<float> errors(100);
  std::iota(errors.begin(), errors.end(), 1.0F);
  std::swap(errors[7], errors[99]);  // 100 stands at place 7
  const ErrorSummary summary = summarize(errors);
  EXPECT_EQ(summary.count, 100U);
  EXPECT_DOUBLE_EQ(summary.mean, 50.5);
  EXPECT_EQ(summary.p50, 50.0);
  EXPECT_EQ(summary.p95, 95.0);
  EXPECT_EQ(summary.p99, 99.0);
  EXPECT_EQ(summary.max, 100.0);
  EXPECT_EQ(summary.worst, 7U);
}

TEST(Metrics, OneValueIsEveryPercentile) {
  const ErrorSummary summary = summarize(std::vector<float>{0.25F});
  EXPECT_EQ(summary.p50, 0.25);
  EXPECT_EQ(summary.p95, 0.25);
  EXPECT_EQ(summary.p99, 0.25);
  EXPECT_EQ(summary.max, 0.25);
}

TEST(Metrics, NothingHasNoFigures) {
  const ErrorSummary summary = summarize({});
  EXPECT_EQ(summary.count, 0U);
  EXPECT_TRUE(std::isnan(summary.mean));
  EXPECT_TRUE(std::isnan(summary.max));
}

TEST(Metrics, AreaChoosesPixelsInEveryChannelLaidEndToEnd) {
  const std::vector<RegionBits> bits = {1, 2, 3};
  const std::vector<float> errors = {1, 2, 3, 10, 20, 30};  // two channels of three pixels
  const ErrorSummary first = summarize(errors, {.bits = bits, .wanted = 1});
  EXPECT_EQ(first.count, 4U);
  EXPECT_DOUBLE_EQ(first.mean, (1 + 3 + 10 + 30) / 4.0);
  const ErrorSummary second = summarize(errors, {.bits = bits, .wanted = 2});
  EXPECT_DOUBLE_EQ(second.mean, (2 + 3 + 20 + 30) / 4.0);
  EXPECT_EQ(second.worst, 5U);
  EXPECT_EQ(summarize(errors, {.bits = bits, .wanted = 4}).count, 0U);
}

TEST(Metrics, ScratchOfACallBeforeChangesNothing) {
  const std::vector<RegionBits> bits = {1, 2, 3};
  const std::vector<float> one = {1, 2, 3};
  const std::vector<float> other = {10, 20, 30};
  const std::vector<std::span<const float>> both = {one, other};
  std::vector<float> scratch;
  EXPECT_EQ(summarize(both, {}, scratch).max, 30.0);
  const ErrorSummary part = summarize(both, {.bits = bits, .wanted = 1}, scratch);
  EXPECT_EQ(part.count, 4U);
  EXPECT_EQ(part.p50, 3.0);
  EXPECT_EQ(part.worst, 5U);
  EXPECT_EQ(summarize(std::span(both).first(1), {}, scratch).p99, 3.0);
}

TEST(Metrics, NonfiniteEqualsNothing) {
  const std::vector<float> values = {kNotANumber, kInf, -kInf, 1.0F};
  const std::vector<float> errors = absolute_errors(values, values);
  EXPECT_EQ(errors[0], kInf);
  EXPECT_EQ(errors[1], kInf);
  EXPECT_EQ(errors[2], kInf);
  EXPECT_EQ(errors[3], 0.0F);
  const ErrorSummary summary = summarize(errors);
  EXPECT_EQ(summary.infinite, 3U);
  EXPECT_EQ(summary.max, kInf);
  EXPECT_EQ(count_over(errors, 1e30), 3U);
  EXPECT_EQ(count_over(errors, std::numeric_limits<double>::infinity()), 3U);
  EXPECT_EQ(deviation(values, values).rms(), std::numeric_limits<double>::infinity());
}

TEST(Metrics, NonfiniteMayEqualItsOwnKindAlone) {
  const std::vector<float> a = {kNotANumber, kInf, kInf, kNotANumber, 1.0F};
  const std::vector<float> b = {kNotANumber, kInf, -kInf, 1.0F, kInf};
  const std::vector<float> errors = absolute_errors(a, b, NonfiniteRule::equal_to_same);
  EXPECT_EQ(errors, (std::vector<float>{0.0F, 0.0F, kInf, kInf, kInf}));
  EXPECT_EQ(relative_errors(a, b, 1.0, NonfiniteRule::equal_to_same), errors);
  const std::vector<float> same = {kNotANumber, 2.0F};
  EXPECT_EQ(deviation(same, same, {}, NonfiniteRule::equal_to_same).rms(), 0.0);
}

TEST(Metrics, MeanMagnitudeLeavesNonfiniteOut) {
  EXPECT_DOUBLE_EQ(mean_magnitude(std::vector<float>{kNotANumber, -2.0F, kInf, 4.0F}), 3.0);
  EXPECT_EQ(mean_magnitude(std::vector<float>{kNotANumber}), 0.0);
}

TEST(Metrics, RmsPsnrAndBias) {
  const std::vector<float> a = {1.0F, 2.0F, 13.0F};
  const std::vector<float> b = {2.0F, 2.0F, 10.0F};
  const Deviation result = deviation(a, b);
  EXPECT_DOUBLE_EQ(result.rms(), std::sqrt(10.0 / 3.0));
  EXPECT_DOUBLE_EQ(result.psnr(), 20.0 * std::log10(10.0 / std::sqrt(10.0 / 3.0)));
  EXPECT_DOUBLE_EQ(result.bias(), 2.0 / 14.0);
  EXPECT_TRUE(std::isinf(deviation(b, b).psnr()));
  EXPECT_EQ(deviation(b, b).bias(), 0.0);
}

TEST(Metrics, DeviationsOfChannelsAdd) {
  Deviation sum = deviation(std::vector<float>{1.0F}, std::vector<float>{0.0F});
  sum += deviation(std::vector<float>{5.0F, 5.0F}, std::vector<float>{3.0F, 4.0F});
  EXPECT_DOUBLE_EQ(sum.rms(), std::sqrt((1.0 + 4.0 + 1.0) / 3.0));
  EXPECT_EQ(sum.peak, 4.0);
}

TEST(Metrics, SigmasAndChiSquare) {
  const std::vector<float> a = {1.0F, 2.0F, 5.0F, 7.0F};
  const std::vector<float> b = {2.0F, 4.0F, 5.0F, 8.0F};
  const std::vector<float> sigma = {0.5F, 1.0F, 0.0F, 0.0F};
  const std::vector<float> errors = sigma_errors(a, b, sigma);
  EXPECT_EQ(errors, (std::vector<float>{2.0F, 2.0F, 0.0F, kInf}));
  const ChiSquare result = chi_square(a, b, sigma);
  EXPECT_EQ(result.count, 2U);
  EXPECT_DOUBLE_EQ(result.per_value(), 4.0);
  EXPECT_EQ(result.unequal_exact, 1U);
}

TEST(Metrics, ChiSquaresOfChannelsAdd) {
  const std::vector<float> zero = {0.0F, 0.0F};
  ChiSquare sum = chi_square(std::vector<float>{2.0F, 1.0F}, zero, std::vector<float>{1.0F, 0.0F});
  sum += chi_square(std::vector<float>{4.0F, 1.0F}, zero, std::vector<float>{1.0F, 0.0F});
  EXPECT_DOUBLE_EQ(sum.per_value(), 10.0);
  EXPECT_EQ(sum.unequal_exact, 2U);
}

TEST(Metrics, OverMeansAbove) {
  const std::vector<float> errors = {0.25F, 0.5F, 0.5F};
  EXPECT_EQ(count_over(errors, 0.25), 2U);
  EXPECT_EQ(count_over(errors, 0.5), 0U);
  EXPECT_EQ(summarize(errors).worst, 1U);  // the first of the largest
}

TEST(Metrics, HugeFiniteDifferenceStaysFinite) {
  const float huge = std::numeric_limits<float>::max();
  const std::vector<float> errors = absolute_errors(std::vector<float>{huge}, std::vector<float>{-huge});
  EXPECT_EQ(errors[0], huge);
}

}  // namespace
}  // namespace airlight::measure
