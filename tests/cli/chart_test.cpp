// The command chart: its files, its resumption, its refusals. Also render --tolerance and --time-limit.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class Chart : public SmallSky {
 protected:
  // A rough truth, since its accuracy is not tested.
  Outcome chart(const std::map<std::string, std::string>& environment = {}) const {
    Start start;
    start.environment = environment;
    return tool({"chart", "sky.json", "-o", "c", "--size", "32x18", "--method", "analytic", "--method", "nested",
                 "--truth-error", "90%", "--truth", "truth", "--json"},
                start);
  }
  bool has(const std::string& file) const { return std::filesystem::exists(scratch_.path() / file); }
};

TEST_F(Chart, WritesItsFilesAndGoesOnWhereItWas) {
  const Outcome first = chart();
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.err, "c/chart.csv\nc/chart.json\nc/chart.gp\nc/chart.svg\nc/chart.png\n");
  for (const char* file : {"c/chart.csv", "c/chart.json", "c/chart.gp", "c/chart.svg", "c/chart.png"}) {
    EXPECT_TRUE(has(file)) << file;
  }
  EXPECT_EQ(scratch_.read("c/chart.png").substr(1, 3), "PNG");
  EXPECT_TRUE(contains(scratch_.read("c/chart.svg"), "</svg>"));
  const Json json = Json::parse(first.out);
  EXPECT_EQ(first.out, scratch_.read("c/chart.json"));
  EXPECT_EQ(json["points"].size(), 7U);
  EXPECT_EQ(json["width"], 32);
  int on_frontier = 0;
  double last = 0.0;
  for (const Json& point : json["points"]) {
    EXPECT_EQ(point["scene"], "sky.json");
    EXPECT_GE(point["time_ms"].get<double>(), last) << "sorted by time";
    last = point["time_ms"].get<double>();
    EXPECT_GT(point["error_mean"].get<double>(), 0.0) << point;
    EXPECT_LT(point["error_mean"].get<double>(), 1.0) << point;
    EXPECT_GE(point["runs"].get<int>(), 1);
    on_frontier += point["frontier"].get<bool>() ? 1 : 0;
  }
  EXPECT_GE(on_frontier, 1);

  const std::string table = scratch_.read("c/chart.csv");
  const Outcome again = chart();
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "7 of 7 points were there already")) << again.err;
  EXPECT_EQ(scratch_.read("c/chart.csv"), table);

  // A missing point is measured anew; the others stay.
  scratch_.write("c/chart.csv", table.substr(0, table.rfind('\n', table.size() - 2) + 1));
  EXPECT_TRUE(contains(chart().err, "6 of 7 points were there already"));

  scratch_.write("c/chart.csv", "a,b\n");
  const Outcome damaged = chart();
  EXPECT_EQ(damaged.exit_code, 2);
  EXPECT_TRUE(contains(damaged.err, "chart.csv:1:")) << damaged.err;
}

TEST_F(Chart, WithoutGnuplotStillWritesItsData) {
  const Outcome outcome = chart({{"PATH", scratch_.path().string()}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "apt-get install gnuplot-nox")) << outcome.err;
  EXPECT_EQ(lines_of(outcome.err).size(), 4U) << outcome.err;
  EXPECT_TRUE(has("c/chart.csv") && has("c/chart.json") && has("c/chart.gp"));
  EXPECT_FALSE(has("c/chart.svg") || has("c/chart.png"));
}

TEST_F(Chart, GnuplotThatFailsLeavesNoPicture) {
  std::filesystem::create_directory(scratch_.path() / "bin");
  const std::filesystem::path program = scratch_.write("bin/gnuplot", "#!/bin/sh\necho no terminal here >&2\nexit 3\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const Outcome outcome = chart({{"PATH", (scratch_.path() / "bin").string()}});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "gnuplot could not draw c/chart.gp: no terminal here")) << outcome.err;
  EXPECT_FALSE(has("c/chart.svg") || has("c/chart.png"));
}

// Methods that do not know a scene's things are left out, unless they are asked for.
TEST_F(Chart, OfThingsHasTheMethodsThatKnowThem) {
  scratch_.write("one.json", R"({"airlight": 1, "extends": "sky.json", "scene": {"spheres": [
    {"azimuth_deg": 0, "elevation_deg": 5, "distance_m": 6, "radius_m": 1, "material": "translucent"}]}})");
  const auto chart_of = [&](const Names& more) {
    Names words{"chart", "one.json", "-o", "c", "--size", "16x9", "--truth-error", "90%", "--truth", "truth", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return tool(words);
  };
  const Outcome known = chart_of({"--budget", "20"});
  ASSERT_EQ(known.exit_code, 0) << known.err;
  EXPECT_TRUE(contains(known.out, "\"orders\""));
  EXPECT_FALSE(contains(known.out, "\"analytic\""));
  const Outcome asked = chart_of({"--method", "analytic"});
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_TRUE(contains(asked.err, "one.json: --method analytic knows no spheres; choose a preset without"))
      << asked.err;
}

using Tolerance = Chart;

TEST_F(Tolerance, IsMetAndToldEverywhere) {
  const Outcome outcome = tool({"render", "sky.json", "--tolerance", "10%", "-o", "a.exr", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "chose ") && contains(outcome.err, "of 10 % allowed")) << outcome.err;
  const Json json = Json::parse(outcome.out);
  const Json choice = json["choice"];
  EXPECT_EQ(choice["method"], json["method"]);
  EXPECT_EQ(choice["tolerance"], 0.1);
  EXPECT_LE(choice["estimated_error"].get<double>(), 0.1);
  EXPECT_EQ(choice["tried"].back()["quality"], choice["quality"]);
  for (const Json& line : choice["left_out"]) {
    EXPECT_NE(std::find(json["left_out"].begin(), json["left_out"].end(), line), json["left_out"].end());
  }
  const std::string exr = scratch_.read("a.exr");
  for (const char* attribute : {"airlight:quality", "airlight:estimated_error", "airlight:left_out"}) {
    EXPECT_TRUE(contains(exr, attribute)) << attribute;
  }
  // The EXR carries the choice as its preset.
  const Outcome again = tool({"render", "a.exr", "-o", "b.exr", "--json"});
  EXPECT_EQ(Json::parse(again.out)["method"], json["method"]) << again.err;
}

TEST_F(Tolerance, DryRunExplainsAndWritesNothing) {
  const Outcome outcome =
      tool({"render", "sky.json", "--tolerance", "20%", "--method", "analytic", "--dry-run", "-o", "a.exr"});
  if (outcome.exit_code == 0) {
    EXPECT_TRUE(contains(outcome.out, "tried, by rising cost:\n  analytic")) << outcome.out;
  } else {
    EXPECT_TRUE(contains(outcome.err, "the best is analytic")) << outcome.err;
  }
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Tolerance, ThatNothingReachesNamesTheBest) {
  const Outcome outcome = tool({"render", "sky.json", "--tolerance", "0.0001%", "--method", "analytic", "-o", "a.exr"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "the best is analytic, ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "--method path-trace")) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

// The sky at dusk is one of which too little is known for 1 %.
TEST_F(Tolerance, ThatTakesTooLongToJudgeSaysHowToGoOn) {
  const Outcome outcome = tool({"render", "sky.json", "--tolerance", "0.5%", "--method", "orders", "-o", "a.exr",
                                "--sun-elevation", "-5", "--judge-time", "0.001ms"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "path-trace could not tell how accurate orders, default is here; ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "allow more time, as by --judge-time 1s")) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Tolerance, ASearchThatTakesTooLongSaysHowToGoOn) {
  const Outcome outcome =
      tool({"render", "sky.json", "--tolerance", "1%", "--method", "march", "-o", "a.exr", "--judge-time", "0.001ms"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "nothing was found that is sure to be that accurate; march, ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "allow more time, as by --judge-time 1s")) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Tolerance, TimeLimitChoosesOrStopsSampling) {
  const Outcome chosen =
      tool({"render", "sky.json", "--time-limit", "1min", "--method", "analytic", "-o", "a.exr", "--json"});
  ASSERT_EQ(chosen.exit_code, 0) << chosen.err;
  const Json choice = Json::parse(chosen.out)["choice"];
  EXPECT_EQ(choice["method"], "analytic");
  EXPECT_EQ(choice["time_limit_ms"], 60000.0);
  EXPECT_GT(choice["device_ms"].get<double>(), 0.0);
  const Outcome never =
      tool({"render", "sky.json", "--time-limit", "0.000001ms", "--method", "analytic", "-o", "b.exr"});
  EXPECT_EQ(never.exit_code, 2);
  EXPECT_TRUE(contains(never.err, "the fastest is analytic")) << never.err;
  const Outcome sampled =
      tool({"render", "sky.json", "--time-limit", "10ms", "--method", "path-trace", "-o", "c.exr", "--json"});
  ASSERT_EQ(sampled.exit_code, 0) << sampled.err;
  EXPECT_EQ(Json::parse(sampled.out)["method"], "path-trace");
  EXPECT_FALSE(Json::parse(sampled.out).contains("choice"));
  EXPECT_FALSE(has("b.exr"));
}

}  // namespace
}  // namespace airlight::test
