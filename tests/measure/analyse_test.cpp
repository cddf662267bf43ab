#include "core/measure/analyse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight::measure {
namespace {

PicturePair pair_of(std::vector<Plane> planes, int columns, int rows) {
  PicturePair pair;
  pair.frame = {.width = columns, .height = rows, .left = 0, .top = 0, .columns = columns, .rows = rows};
  pair.planes = std::move(planes);
  return pair;
}

const ChannelReport& channel(const AreaReport& area, std::string_view name) {
  for (const ChannelReport& report : area.channels) {
    if (report.name == name) return report;
  }
  throw std::out_of_range(std::string(name));
}

TEST(Analyse, PoolsTheColoursAndAddsLuminance) {
  const PicturePair pair = pair_of({{"R", {1.1F, 1.0F}, {1.0F, 1.0F}, {}},
                                    {"G", {1.0F, 1.0F}, {1.0F, 1.0F}, {}},
                                    {"B", {1.0F, 1.5F}, {1.0F, 1.0F}, {}},
                                    {"A", {0.0F, 0.0F}, {1.0F, 1.0F}, {}}},
                                   2, 1);
  Limits limits;
  limits.fail = 0.2;
  ComparisonReport report;
  const std::vector<float> map = analyse(pair, limits, report);
  ASSERT_EQ(report.areas.size(), 1U);
  const AreaReport& whole = report.areas.front();
  EXPECT_EQ(whole.channels.back().name, "pooled");
  const ChannelReport& pooled = whole.channels.back();
  EXPECT_EQ(pooled.relative.count, 6U);
  EXPECT_NEAR(pooled.relative.mean, 0.1, 1e-6);
  EXPECT_EQ(pooled.worst_relative.channel, "B");
  EXPECT_EQ(pooled.worst_relative.x, 1);
  EXPECT_EQ(pooled.worst_relative.a, 1.5);
  EXPECT_EQ(pooled.over_fail, 1U);
  EXPECT_NEAR(channel(whole, "luminance").absolute.max, 0.5 * 0.0722, 1e-4);
  // Alpha is judged, though not pooled.
  EXPECT_EQ(report.pixels_over_fail, 2U);
  EXPECT_EQ(report.largest, 1.0);
  EXPECT_EQ(map, (std::vector<float>{1.0F, 1.0F}));
}

// Large pictures are analysed by several threads.
TEST(Analyse, ALargePictureHasTheFiguresOfItsValues) {
  constexpr int kColumns = 400;
  constexpr int kRows = 300;
  std::vector<Plane> planes;
  std::vector<float> all;  // relative errors of the pooled channels
  unsigned state = 1;
  for (const char* name : {"R", "G", "B"}) {
    Plane plane{name, {}, std::vector<float>(std::size_t{kColumns} * kRows, 1.0F), {}};
    for (std::size_t i = 0; i < plane.b.size(); ++i) {
      state = state * 1664525U + 1013904223U;
      plane.a.push_back(1.0F + static_cast<float>(state >> 8) / 16777216.0F);
      all.push_back(plane.a.back() - 1.0F);
    }
    plane.sigma.assign(plane.a.size(), 0.5F);
    planes.push_back(plane);
  }
  PicturePair pair = pair_of(planes, kColumns, kRows);
  pair.in_sigmas = true;
  Limits limits;
  limits.fail = 1.0;
  ComparisonReport report;
  analyse(pair, limits, report);
  const ChannelReport& pooled = report.areas.front().channels.back();
  std::vector<float> sorted = all;
  std::ranges::sort(sorted);
  const auto rank = [&](double share) {
    return static_cast<double>(sorted[static_cast<std::size_t>(share * 360000) - 1]);
  };
  EXPECT_EQ(pooled.relative.count, 360000U);
  EXPECT_EQ(pooled.relative.p50, rank(0.50));
  EXPECT_EQ(pooled.relative.p95, rank(0.95));
  EXPECT_EQ(pooled.relative.p99, rank(0.99));
  EXPECT_EQ(pooled.relative.max, static_cast<double>(sorted.back()));
  EXPECT_EQ(pooled.relative.worst, static_cast<std::size_t>(std::ranges::max_element(all) - all.begin()));
  EXPECT_EQ(pooled.absolute.p50, rank(0.50));
  ASSERT_TRUE(pooled.sigma && pooled.chi_square);
  EXPECT_EQ(pooled.sigma->p50, 2.0 * rank(0.50));
  EXPECT_EQ(pooled.chi_square->count, 360000U);
  EXPECT_EQ(pooled.deviation.count, 360000U);
  EXPECT_EQ(pooled.over_fail, static_cast<std::size_t>(std::ranges::count_if(all, [](float e) { return e > 0.5F; })));
}

TEST(Analyse, WithoutRgbEveryChannelIsPooled) {
  const PicturePair pair = pair_of({{"Z", {2.0F}, {1.0F}, {}}, {"Y", {1.0F}, {1.0F}, {}}}, 1, 1);
  ComparisonReport report;
  analyse(pair, {}, report);
  ASSERT_EQ(report.areas.front().channels.size(), 3U);
  EXPECT_EQ(report.areas.front().channels.back().relative.count, 2U);
  EXPECT_NEAR(report.areas.front().channels.back().relative.mean, 0.5, 1e-7);
}

TEST(Analyse, RegionsOfTheSky) {
  PicturePair pair = pair_of({{"Y", std::vector<float>(64 * 32, 1.0F), std::vector<float>(64 * 32, 1.0F), {}}}, 64, 32);
  for (std::size_t i = 64 * 31; i < 64 * 32; ++i) pair.planes[0].a[i] = 2.0F;  // the lowest row: ground
  pair.viewpoint.emplace();
  pair.viewpoint->camera.projection = Projection::equirectangular;
  pair.viewpoint->sun_elevation = 30.0 * kDegree;
  ComparisonReport report;
  analyse(pair, {}, report);
  const auto area = [&](std::string_view name) {
    for (const AreaReport& candidate : report.areas) {
      if (candidate.name == name) return candidate;
    }
    return AreaReport{};
  };
  EXPECT_EQ(area("sky").pixels, 64U * 16U);
  EXPECT_EQ(area("sky").channels.back().relative.max, 0.0);
  EXPECT_EQ(area("ground").channels.back().relative.max, 1.0);
  EXPECT_EQ(area("ground").channels.back().worst_relative.y, 31);
  EXPECT_NEAR(*area("ground").channels.back().worst_relative.elevation_deg, -87.1875, 1e-9);
  EXPECT_GT(area("sun aureole").pixels, 0U);
  EXPECT_GT(area("zenith").pixels, 0U);
  EXPECT_GT(area("horizon band").pixels, 0U);
}

TEST(Analyse, AlphaWithoutAStandardErrorMustBeEqual) {
  PicturePair pair = pair_of({{"R", {1.5F}, {1.0F}, {0.5F}}, {"A", {1.0F}, {1.0F}, {}}}, 1, 1);
  pair.in_sigmas = true;
  ComparisonReport equal;
  analyse(pair, {}, equal);
  EXPECT_EQ(equal.largest, 1.0);
  pair.planes[1].a[0] = 0.5F;
  ComparisonReport different;
  analyse(pair, {}, different);
  EXPECT_TRUE(std::isinf(different.largest));
}

}  // namespace
}  // namespace airlight::measure
