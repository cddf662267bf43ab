// The chart's points as data: frontier, means over the scenes, the table written and read back.
#include "core/chart/points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace airlight::chart {
namespace {

Point point(const std::string& scene, const std::string& quality, double time, double error) {
  Point p;
  p.scene = scene;
  p.method = "march";
  p.quality = quality;
  p.time_ms = time;
  p.error_mean = error;
  p.error_p95 = 2.0 * error;
  p.key = "0123";
  return p;
}

std::vector<std::string> on_frontier(const std::vector<Point>& points) {
  std::vector<std::string> names;
  for (const Point& p : points) {
    if (p.frontier) {
      names.push_back(p.scene + " " + p.quality);
    }
  }
  return names;
}

TEST(Frontier, KeepsWhatNothingBeatsInBothSceneByScene) {
  std::vector<Point> points{point("noon", "slow and wrong", 30, 0.5), point("noon", "slow", 20, 0.01),
                            point("noon", "fast", 1, 0.3), point("noon", "dominated", 21, 0.02),
                            point("night", "alone", 99, 0.9)};
  mark_frontier(points);
  EXPECT_EQ(on_frontier(points), (std::vector<std::string>{"noon slow", "noon fast", "night alone"}));
}

TEST(Frontier, OfEquallyFastPointsHoldsTheMoreAccurate) {
  std::vector<Point> points{point("noon", "worse", 5, 0.2), point("noon", "better", 5, 0.1),
                            point("noon", "no better", 6, 0.1)};
  mark_frontier(points);
  EXPECT_EQ(on_frontier(points), (std::vector<std::string>{"noon better"}));
}

TEST(AllScenes, AreGeometricMeansOfWhatEverySceneHas) {
  const std::vector<Point> means =
      over_all_scenes({point("noon", "8", 2, 0.04), point("night", "8", 8, 0.01), point("noon", "16", 3, 0.1)});
  ASSERT_EQ(means.size(), 1U);
  EXPECT_EQ(means[0].scene, kAllScenes);
  EXPECT_EQ(means[0].quality, "8");
  EXPECT_NEAR(means[0].time_ms, 4.0, 1e-12);
  EXPECT_NEAR(means[0].error_mean, 0.02, 1e-12);
  EXPECT_EQ(means[0].key, "");
}

TEST(AllScenes, LeaveTheOldMeansOut) {
  std::vector<Point> points{point("noon", "8", 2, 0.04), point("night", "8", 8, 0.01)};
  const std::vector<Point> means = over_all_scenes(points);
  points.insert(points.end(), means.begin(), means.end());
  EXPECT_EQ(over_all_scenes(points).size(), 1U);
}

TEST(Order, IsTheScenesThenTheTimes) {
  std::vector<Point> points{point("all", "8", 1, 1), point("b", "slow", 9, 1), point("b", "fast", 1, 1),
                            point("a", "slow", 7, 1)};
  sort_points(points, {"b", "a"});
  std::string order;
  for (const Point& p : points) {
    order += p.scene + " " + p.quality + "; ";
  }
  EXPECT_EQ(order, "b fast; b slow; a slow; all 8; ");
}

TEST(Table, ComesBackAsItWas) {
  Point odd = point("a \"quoted\", name", "192 x 108, 32 steps", 1.0 / 3.0, 1e-9);
  odd.floor = 1e300;
  odd.runs = 15;
  odd.frontier = true;
  odd.share_timed = 0.001;
  const std::vector<Point> points{odd, point("noon", "8", 2, 0.04)};
  const std::vector<Point> again = read_csv(csv_text(points), "chart.csv");
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[0].scene, odd.scene);
  EXPECT_EQ(again[0].quality, odd.quality);
  EXPECT_EQ(again[0].time_ms, odd.time_ms);
  EXPECT_EQ(again[0].floor, odd.floor);
  EXPECT_EQ(again[0].runs, 15);
  EXPECT_TRUE(again[0].frontier);
  EXPECT_EQ(csv_text(again), csv_text(points));
}

std::string refusal(const std::string& text) {
  try {
    read_csv(text, "chart.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Table, ThatIsDamagedIsRefusedWithItsLine) {
  const std::string good = csv_text({point("noon", "8", 2, 0.04)});
  EXPECT_NE(refusal("").find("chart.csv:1:"), std::string::npos);
  EXPECT_NE(refusal("a,b\n1,2\n").find("chart.csv:1:"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() - 2)).find("chart.csv:2:"), std::string::npos);
  EXPECT_NE(refusal(good + "\"noon\",\"march\"\n").find("chart.csv:3: has 2 cells"), std::string::npos);
  std::string wrong = good;
  wrong.replace(wrong.find("0.04"), 4, "high");
  EXPECT_NE(refusal(wrong).find("'high' is no error_mean"), std::string::npos) << refusal(wrong);
}

}  // namespace
}  // namespace airlight::chart
