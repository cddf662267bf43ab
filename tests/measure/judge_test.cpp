#include "core/measure/judge.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/member.h"
#include "core/measure/analyse.h"

namespace airlight::measure {
namespace {

// 100 pixels in one channel, all 1 in B; A differs by `difference` in the first `count`.
ComparisonReport compare(const Limits& given, int count, float difference, std::vector<float> sigma = {},
                         NonfiniteRule rule = NonfiniteRule::never_equal) {
  PicturePair pair;
  pair.frame = {.width = 10, .height = 10, .left = 0, .top = 0, .columns = 10, .rows = 10};
  pair.in_sigmas = !sigma.empty();
  pair.nonfinite = rule;
  Plane plane{
      .name = "Y", .a = std::vector<float>(100, 1.0F), .b = std::vector<float>(100, 1.0F), .sigma = std::move(sigma)};
  for (int i = 0; i < count; ++i) plane.a[static_cast<std::size_t>(i)] += difference;
  pair.planes.push_back(std::move(plane));
  ComparisonReport report;
  const Limits limits = limits_in_force(given, pair.in_sigmas);
  analyse(pair, limits, report);
  judge(limits, pair.in_sigmas, report);
  return report;
}

Limits with(MemberOf<Limits, std::optional<double>> member, double value) {
  Limits limits;
  limits.*member = value;
  return limits;
}

TEST(Judge, DefaultIsIdiffs) {
  EXPECT_EQ(*limits_in_force({}, false).fail, 1e-6);
  EXPECT_EQ(compare({}, 0, 0.0F).verdict, Verdict::pass);
  EXPECT_EQ(compare({}, 1, 4e-7F).verdict, Verdict::pass);
  EXPECT_EQ(compare({}, 1, 2e-6F).verdict, Verdict::differ);
  EXPECT_EQ(compare(with(&Limits::hard_fail, 0.5), 1, 0.25F).verdict, Verdict::differ);
}

TEST(Judge, FailPercentIsOfPixels) {
  Limits limits = with(&Limits::fail, 0.1);
  limits.fail_percent = 5.0;
  EXPECT_EQ(compare(limits, 5, 0.25F).verdict, Verdict::pass);
  const ComparisonReport six = compare(limits, 6, 0.25F);
  EXPECT_EQ(six.verdict, Verdict::differ);
  EXPECT_EQ(six.pixels_over_fail, 6U);
  ASSERT_EQ(six.reasons.size(), 1U);
  EXPECT_EQ(six.reasons[0], "6 of 100 pixels (6 %) differ by more than 0.1; 5 % may");
}

TEST(Judge, HardFailKnowsNoPercentage) {
  Limits limits = with(&Limits::hard_fail, 0.2);
  limits.fail = 0.1;
  limits.fail_percent = 50.0;
  EXPECT_EQ(compare(limits, 10, 0.15F).verdict, Verdict::pass);
  EXPECT_EQ(compare(limits, 1, 0.25F).verdict, Verdict::differ);
}

TEST(Judge, WarningsPass) {
  Limits limits = with(&Limits::fail, 1.0);
  limits.warn = 0.1;
  EXPECT_EQ(compare(limits, 1, 0.05F).verdict, Verdict::pass);
  const ComparisonReport warned = compare(limits, 3, 0.25F);
  EXPECT_EQ(warned.verdict, Verdict::warn);
  EXPECT_EQ(warned.pixels_over_warn, 3U);
  EXPECT_EQ(warned.reasons.size(), 1U);
  limits.warn_percent = 3.0;
  EXPECT_EQ(compare(limits, 3, 0.25F).verdict, Verdict::pass);
  limits.hard_warn = 0.2;
  EXPECT_EQ(compare(limits, 3, 0.25F).verdict, Verdict::warn);
}

TEST(Judge, RelativeLimitsJudgeAlone) {
  EXPECT_FALSE(limits_in_force(with(&Limits::relative_mean, 0.1), false).fail);
  // 10 of 100 pixels 25 % too bright: mean 2.5 %, 95th percentile and maximum 25 %.
  EXPECT_EQ(compare(with(&Limits::relative_mean, 0.026), 10, 0.25F).verdict, Verdict::pass);
  EXPECT_EQ(compare(with(&Limits::relative_mean, 0.024), 10, 0.25F).verdict, Verdict::differ);
  EXPECT_EQ(compare(with(&Limits::relative_p95, 0.1), 5, 0.25F).verdict, Verdict::pass);
  EXPECT_EQ(compare(with(&Limits::relative_p95, 0.1), 6, 0.25F).verdict, Verdict::differ);
  EXPECT_EQ(compare(with(&Limits::relative_max, 0.26), 100, 0.25F).verdict, Verdict::pass);
  EXPECT_EQ(compare(with(&Limits::relative_max, 0.24), 1, 0.25F).verdict, Verdict::differ);
}

TEST(Judge, NanFailsUnderAnyLimits) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Limits generous = with(&Limits::fail, 1e30);
  generous.fail_percent = 100.0;
  const ComparisonReport report = compare(generous, 1, nan);
  EXPECT_EQ(report.verdict, Verdict::differ);
  EXPECT_EQ(report.unequal_nonfinite, 1U);
  EXPECT_EQ(compare(with(&Limits::relative_p95, 1e30), 1, nan).verdict, Verdict::differ);
  // Equal to its own kind is allowed, but never equal to a number.
  EXPECT_EQ(compare(generous, 1, nan, {}, NonfiniteRule::equal_to_same).verdict, Verdict::differ);
}

TEST(Judge, StandardErrorsAreTheUnit) {
  const std::vector<float> sigma(100, 0.125F);
  const Limits limits = limits_in_force({}, true);
  EXPECT_EQ(*limits.fail, kDefaultSigmaFail);
  EXPECT_EQ(compare({}, 100, 0.125F, sigma).verdict, Verdict::pass);  // chi-square 1
  const ComparisonReport far = compare({}, 1, 0.625F, sigma);         // one pixel at 5 sigmas, 1 % > 0.5 %
  EXPECT_EQ(far.verdict, Verdict::differ);
  EXPECT_DOUBLE_EQ(far.largest, 5.0);
  const ComparisonReport wide = compare({}, 100, 0.25F, sigma);  // chi-square 4, no pixel beyond 4 sigmas
  EXPECT_EQ(wide.verdict, Verdict::differ);
  ASSERT_EQ(wide.reasons.size(), 1U);
  EXPECT_EQ(wide.reasons[0], "chi-square per value 4 is above 1.5");
  EXPECT_EQ(compare(with(&Limits::chi_square, 4.0), 100, 0.25F, sigma).verdict, Verdict::pass);
}

TEST(Judge, NoStandardErrorMeansEqual) {
  EXPECT_EQ(compare({}, 0, 0.0F, std::vector<float>(100, 0.0F)).verdict, Verdict::pass);
  EXPECT_EQ(compare({}, 1, 1e-3F, std::vector<float>(100, 0.0F)).verdict, Verdict::differ);
}

}  // namespace
}  // namespace airlight::measure
