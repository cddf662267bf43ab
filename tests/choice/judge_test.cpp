// The error of pictures judged by paths; the tests supply the paths.
#include "core/choice/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "core/base/clock.h"
#include "core/choice/assumed_error.h"
#include "core/gpu/kept_values.h"
#include "core/methods/method.h"
#include "core/scene/thing_kinds.h"
#include "tests/choice/looks.h"
#include "tests/choice/of_scene.h"
#include "tests/output/files.h"

namespace airlight::choice {
namespace {

// No choice asks whether a scene can be traced.
TEST(Tolerance, TheJudgeKnowsAllThings) {
  const MethodInfo& judge = find_method("path-trace")->info;
  EXPECT_EQ(judge.misfits, nullptr);
  for (const ThingKind& kind : kThingKinds) {
    EXPECT_TRUE(judge.*kind.known) << kind.name;
  }
}

// An assumed error of the reference is dropped where paths contradict it (seed 1227).
TEST(Tolerance, PathsCountMoreThanWhatIsKnown) {
  Scene scene = preset("noon");
  scene.sun.elevation = -0.1;
  ASSERT_FALSE(default_error(scene));
  ASSERT_LT(plain_reference_error(scene).value_or(1.0), 0.015);
  EXPECT_TRUE(choose_for_tolerance(scene, 0.03, "", wrong_by([](const Scene&) { return 0.01; })).chosen);
  EXPECT_FALSE(choose_for_tolerance(scene, 0.03, "", wrong_by([](const Scene&) { return 0.06; })).chosen);
}

// Below the error assumed for haze by day, paths decide, as many as needed and no more.
TEST(Tolerance, PathTraceJudgesWhatNobodyKnows) {
  const Scene scene = haze(kBlue, kForward);
  const double tolerance = 0.5 * *default_error(scene);
  std::vector<TraceOrder> runs;
  const auto judged = [&](double error) {
    runs.clear();
    Looks looks = wrong_by([=](const Scene&) { return error; });
    looks.trace = [&](const Stage&, const Probes& probes, const TraceOrder& order) {
      runs.push_back(order);
      return trace_of_one(probes, order);
    };
    return choose_for_tolerance(scene, tolerance, "orders", looks);
  };
  const Choice good = judged(0.1 * tolerance);
  ASSERT_TRUE(good.chosen);
  EXPECT_EQ(good.chosen->quality, "default");
  EXPECT_GT(good.traced, 100U);
  EXPECT_LE(good.error, tolerance);
  EXPECT_GE(good.error, 0.1 * tolerance);
  const std::size_t few = runs.size();
  EXPECT_GT(runs.front().target_error, 1.5 * tolerance);
  const Choice close = judged(0.9 * tolerance);
  ASSERT_TRUE(close.chosen);
  EXPECT_GE(close.error, 0.9 * tolerance);
  EXPECT_GT(runs.size(), few) << "the first looks could not tell";
  const Choice bad = judged(1.5 * tolerance);
  EXPECT_FALSE(bad.chosen);
  ASSERT_TRUE(bad.best);
  EXPECT_GE(bad.best->error, 1.5 * tolerance);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    EXPECT_GE(runs[i].samples, i > 1 ? runs[i - 1].samples : 1.0) << "on top of all before";
    EXPECT_NE(runs[i].seed, runs[i - 1].seed) << "the same samples again would tell nothing";
  }
  const Choice hopeless = judged(0.2);
  EXPECT_FALSE(hopeless.chosen);
  EXPECT_EQ(runs.size(), 1U) << "few paths tell that";
}

// The time limit covers all runs together, and their results count even if they are not enough.
TEST(Tolerance, TheJudgesTimeIsUpOnce) {
  const Scene scene = haze(kBlue, kForward);
  const double tolerance = 0.5 * *default_error(scene);
  double left = kLongPatience;
  Looks looks = wrong_by([=](const Scene&) { return 0.9 * tolerance; });
  std::vector<double> allowed;
  looks.trace = [&](const Stage&, const Probes& probes, const TraceOrder& order) {
    allowed.push_back(order.cpu_seconds);
    const double start = process_cpu_ms();
    while (process_cpu_ms() < start + 20.0) {
    }
    return trace_of_one(probes, order);
  };
  const Choice choice = choose_for_tolerance(scene, tolerance, "orders", looks);
  ASSERT_FALSE(allowed.empty());
  for (const double seconds : allowed) {
    EXPECT_LE(seconds, left);
    left = seconds - 0.02;
  }
  looks.trace = [&](const Stage&, const Probes&, const TraceOrder&) { return Traced{}; };
  const Choice without = choose_for_tolerance(scene, tolerance, "orders", looks);
  EXPECT_FALSE(without.chosen) << "no paths, no verdict";
}

// How long paths may judge is asked once, when the first are wanted. When that time is up, what they told of the
// defaults is the answer, and nothing else is tried.
TEST(Tolerance, ATimeThatIsUpEndsTheSearch) {
  const Scene scene = haze(kBlue, kForward);
  const double known = *default_error(scene);
  const double tolerance = 0.5 * known;
  int probes = 0;
  int asked = 0;
  double patience = kLongPatience;
  Looks looks = wrong_by([=](const Scene&) { return 0.9 * tolerance; }, &probes);
  looks.patience = [&] {
    ++asked;
    return patience;
  };
  EXPECT_TRUE(choose_for_tolerance(scene, 1.1 * known, "orders", looks).chosen);
  EXPECT_EQ(asked, 0) << "what is known needs no paths";
  const Choice patient = choose_for_tolerance(scene, tolerance, "orders", looks);
  EXPECT_TRUE(patient.chosen);
  EXPECT_FALSE(patient.ran_out);
  EXPECT_EQ(asked, 1);
  patience = 0.0;
  const std::map<std::string, int> wanted{{"", 1}, {"orders", 1}, {"march", 2}};  // probes, with the reference's
  for (const auto& [only, most] : wanted) {
    probes = 0;
    const Choice hasty = choose_for_tolerance(scene, tolerance, only, looks);
    EXPECT_FALSE(hasty.chosen);
    EXPECT_TRUE(hasty.ran_out);
    ASSERT_EQ(hasty.tried.size(), 1U);
    EXPECT_EQ(hasty.best->method, only.empty() ? "orders" : only);
    EXPECT_GT(hasty.best->error, tolerance);
    EXPECT_LT(hasty.best->error, 0.1) << "what the first paths told";
    EXPECT_EQ(probes, most) << only;
  }
}

// The whole search has an end too, where no paths are wanted: the best so far is told.
TEST(Tolerance, ASearchWithoutPathsEnds) {
  const Scene scene = haze(kBlue, kForward);
  const double tolerance = 2.0 * *default_error(scene);
  int probes = 0;
  Looks looks = wrong_by([](const Scene& tried) { return tried.render.method == "orders" ? 0.0 : 0.5; }, &probes);
  looks.trace = [](const Stage&, const Probes&, const TraceOrder&) -> Traced {
    throw std::logic_error("what is known needs no paths");
  };
  const Choice whole = choose_for_tolerance(scene, tolerance, "march", looks);
  EXPECT_FALSE(whole.chosen);
  EXPECT_FALSE(whole.ran_out);
  ASSERT_GT(whole.tried.size(), 2U);
  std::size_t allowed = 2;
  looks.is_up = [&] { return --allowed == 0; };
  const Choice ended = choose_for_tolerance(scene, tolerance, "march", looks);
  EXPECT_FALSE(ended.chosen);
  EXPECT_TRUE(ended.ran_out);
  EXPECT_EQ(ended.tried.size(), 2U);
  EXPECT_TRUE(ended.best.has_value());
}

// Tables among terrain cost what the picture does: the defaults alone are looked at, taken or refused.
TEST(Tolerance, AmongTerrainTheDefaultsAreTakenOrRefused) {
  Scene scene = preset("noon");
  Terrain terrain;
  terrain.ridge = Ridge{.seed = 7, .height = 1.0};
  terrain.width = 20.0;
  terrain.distance = 15.0;
  scene.terrain = terrain;
  constexpr double kTolerance = 0.03;
  int calls = 0;
  const auto chosen = [&](double error, const std::string& only) {
    calls = 0;
    return choose_for_tolerance(scene, kTolerance, only, wrong_by([=](const Scene&) { return error; }, &calls));
  };
  for (const std::string only : {"", "orders"}) {
    const Choice good = chosen(0.2 * kTolerance, only);
    ASSERT_TRUE(good.chosen) << only;
    EXPECT_EQ(good.chosen->method + " " + good.chosen->quality, "orders default");
    EXPECT_EQ(good.chosen->stage.scene().render.parameters, scene.render.parameters);
    EXPECT_TRUE(good.left_out.empty());
    EXPECT_GT(good.error, 0.2 * kTolerance);
    EXPECT_LE(good.error, kTolerance);
    EXPECT_EQ(calls, 1) << "more pictures than the one that is taken";
    const Choice bad = chosen(2.0 * kTolerance, only);
    EXPECT_FALSE(bad.chosen) << only;
    ASSERT_TRUE(bad.best);
    EXPECT_GE(bad.best->error, 2.0 * kTolerance);
    EXPECT_EQ(bad.tried.size(), 1U);
    EXPECT_EQ(calls, 1) << only;
  }
}

// Two runs equal one run with all their samples.
TEST(Tolerance, RunsOfPathsAreOne) {
  Probes probes;
  probes.directions.resize(4000);
  const Traced few = trace_of_one(probes, {.seed = 1, .samples = 64.0});
  const Traced many = trace_of_one(probes, {.seed = 2, .samples = 192.0});
  const Traced both = together(few, many);
  EXPECT_EQ(both.samples, 256.0);
  EXPECT_EQ(both.batches, 15.0);
  EXPECT_EQ(together({}, many).radiance, many.radiance);
  EXPECT_EQ(together(many, {}).radiance, many.radiance);
  double squares = 0.0;
  for (const float x : both.radiance) {
    squares += (x - 1.0) * (x - 1.0);
  }
  const double deviation = std::sqrt(squares / static_cast<double>(both.radiance.size()));
  EXPECT_NEAR(both.standard_error.front(), 0.512 / 16.0, 1e-6);
  EXPECT_NEAR(deviation, 0.512 / 16.0, 0.03 * 0.512 / 16.0);
}

// The paths' noise is subtracted, and no error is reported smaller than it is.
TEST(Tolerance, AJudgementHoldsTheErrorBetweenItsBounds) {
  Probes probes;
  probes.directions.resize(128);
  probes.weights.assign(128, 1.0);
  for (const double noise : {0.002, 0.01, 0.02}) {
    const Traced truth = trace_of_one(probes, {.target_error = noise, .samples = 1 << 16});
    for (const double error : {0.0, 0.005, 0.01, 0.05}) {
      const std::vector<float> radiance(3 * 128, static_cast<float>(1.0 + error));
      const Judgement verdict = judge(radiance, truth, probes.weights);
      EXPECT_LE(verdict.at_least, 1.03 * error) << noise;
      EXPECT_GE(verdict.at_most, 0.98 * error) << noise;
      EXPECT_LE(verdict.at_most, error + 0.6 * noise + 0.002) << noise << " " << error;
    }
  }
}

// The deviation estimated from two batches is, in the mean, too small.
TEST(Tolerance, AJudgementKnowsWhatFewBatchesTell) {
  constexpr std::size_t kCount = 20000;
  std::mt19937 random(5);
  std::normal_distribution<float> normal(1.0F, 0.02F);
  Traced truth{
      .radiance = std::vector<float>(3 * kCount), .standard_error = std::vector<float>(3 * kCount), .batches = 2.0};
  for (std::size_t i = 0; i < 3 * kCount; ++i) {
    const float a = normal(random);
    const float b = normal(random);
    truth.radiance[i] = 0.5F * (a + b);
    truth.standard_error[i] = 0.5F * std::abs(a - b);
  }
  const Judgement verdict = judge(std::vector<float>(3 * kCount, 1.0F), truth, std::vector<double>(kCount, 1.0));
  EXPECT_LT(verdict.at_most, 0.0035) << "of a noise of 0.014, and no error at all";
}

// What was traced once is there at the next start: no time is needed for it.
TEST(Tolerance, TracesOfAWishAreKept) {
  const test::Folder folder;
  keep_values_in(folder.path());
  const Stage stage = ready(haze(kBlue, kForward));
  Probes probes;
  probes.directions = {{0.3, 0.0}, {1.2, 2.0}};
  TraceOrder order{.seed = 3, .target_error = 0.0, .samples = 64.0, .cpu_seconds = 60.0};
  const Traced first = trace_probes(stage, probes, order);
  ASSERT_EQ(first.radiance.size(), 6U);
  EXPECT_EQ(first.samples, 64.0);
  EXPECT_EQ(first.batches, 4.0);
  order.cpu_seconds = 0.0;
  const Traced again = trace_probes(stage, probes, order);
  EXPECT_EQ(again.radiance, first.radiance);
  EXPECT_EQ(again.standard_error, first.standard_error);
  EXPECT_EQ(again.samples, 64.0);
  EXPECT_EQ(again.batches, 4.0);
  order.seed = 4;
  EXPECT_TRUE(trace_probes(stage, probes, order).radiance.empty());
  order.seed = 3;
  Scene other = haze(kBlue, kForward);
  other.sun.elevation += 0.01;
  EXPECT_TRUE(trace_probes(ready(other), probes, order).radiance.empty());
  keep_values_in({});
}

}  // namespace
}  // namespace airlight::choice
