// The choice of method and quality for a picture, with probes that need no device.
#include "core/choice/choose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/choice/assumed_error.h"
#include "core/choice/leave_out.h"
#include "tests/choice/looks.h"
#include "tests/choice/of_scene.h"

namespace airlight::choice {
namespace {

TEST(Tolerance, TakesTheFirstOfRisingCostThatIsWithinIt) {
  Scene scene = preset("orbit");
  scene.sun.elevation = -0.1;  // where nothing is known beforehand
  double cost = 0.0;
  for (const double tolerance : {0.1, 0.03, 0.015}) {
    const Choice choice = choose_for_tolerance(scene, tolerance, "", wrong_by(by_steps));
    ASSERT_TRUE(choice.chosen) << tolerance;
    EXPECT_LE(choice.error, tolerance);
    for (const Tried& tried : choice.tried) {
      EXPECT_LE(tried.cost, choice.chosen->cost.total());
      EXPECT_EQ(tried.error <= tolerance, &tried == &choice.tried.back()) << tried.method << " " << tried.quality;
    }
    EXPECT_GE(choice.chosen->cost.total(), cost) << "a finer tolerance is no cheaper";
    cost = choice.chosen->cost.total();
  }
}

// For a scene with spectra the choice takes the fewest wavelengths that agree with many more, and includes their error
// in the bound. A number that the preset gives stays.
TEST(Tolerance, TakesTheFewestWavelengths) {
  Scene scene = preset("earth");
  scene.sun.elevation = -0.1;
  const auto by_wavelengths = wrong_by([](const Scene& s) {
    const int count = s.spectra->wavelengths;
    return count < 4 ? 0.03 : count < 7 ? 0.004 : 0.0;
  });
  const auto chosen_for = [&](double tolerance) {
    return choose_for_tolerance(scene, tolerance, "march", by_wavelengths);
  };
  const Choice rough = chosen_for(0.2);
  ASSERT_TRUE(rough.chosen);
  EXPECT_EQ(rough.chosen->stage.scene().spectra->wavelengths, 3);
  EXPECT_GT(rough.reference_error, 0.03);
  const Choice fine = chosen_for(0.05);
  ASSERT_TRUE(fine.chosen);
  EXPECT_EQ(fine.chosen->stage.scene().spectra->wavelengths, 6);
  EXPECT_GT(fine.reference_error, 0.004);
  scene.spectra->wavelengths = 3;
  EXPECT_FALSE(chosen_for(0.02).chosen);
  EXPECT_EQ(chosen_for(0.2).chosen->stage.scene().spectra->wavelengths, 3);
}

TEST(Tolerance, LooksAtNothingWhereTheDefaultIsSureAndNoSearchPays) {
  int calls = 0;
  const Looks probe = wrong_by(by_steps, &calls);
  const Scene noon = preset("noon");
  const Choice choice = choose_for_tolerance(noon, 0.02, "", probe);
  ASSERT_TRUE(choice.chosen);
  EXPECT_EQ(choice.chosen->method, "orders");
  EXPECT_EQ(choice.chosen->quality, "default");
  EXPECT_EQ(choice.error, *default_error(noon));
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(choose_for_tolerance(noon, *default_error(noon), "orders", probe).probes, 0U);
  EXPECT_GT(choose_for_tolerance(noon, 0.99 * *default_error(noon), "", probe).probes, 0U);
  EXPECT_GT(choose_for_tolerance(noon, 0.02, "march", probe).probes, 0U) << "of another method nothing is known";
  Scene thick = noon;
  for (Medium& medium : thick.media) {
    for (double& scattering : medium.scattering) {
      scattering *= 10.0;
    }
  }
  EXPECT_EQ(choose_for_tolerance(thick, 0.2, "", probe).probes, 0U);
  EXPECT_GT(choose_for_tolerance(thick, 0.03, "", probe).probes, 0U);
  EXPECT_FALSE(search_may_pay(preset("orbit", {64, 36})));
  EXPECT_EQ(choose_for_tolerance(preset("orbit", {64, 36}), 0.05, "", probe).probes, 0U);
}

// A picture without light is black by any method and needs no probe.
TEST(Tolerance, NothingIsLookedAtWhereNothingShines) {
  Scene scene = preset("noon");
  scene.camera.altitude = scene.planet.atmosphere_height;
  scene.sun.irradiance = {0.0, 0.0, 0.0};
  int calls = 0;
  const Choice choice = choose_for_tolerance(scene, 0.001, "", wrong_by(by_steps, &calls));
  ASSERT_TRUE(choice.chosen);
  EXPECT_EQ(choice.chosen->method, "orders");
  EXPECT_EQ(choice.error, 0.0);
  EXPECT_EQ(calls, 0);
}

// Deep in the night methods differ by factors in invisible light; none may be brighter than starlight.
TEST(Tolerance, ByNightAllThatIsDarkIsAlike) {
  Scene scene = preset("noon");
  scene.sun.elevation = -0.6;
  const auto darkness = [](double near_truth, double others) {
    const auto probe = [=](const Stage& s, const Probes& probes) {
      const RenderSettings& render = s.scene().render;
      const bool judge = render.method == "orders" && render.get<int>("steps") == 192;
      return std::vector<float>(3 * probes.directions.size(), static_cast<float>(judge ? near_truth : others));
    };
    const auto trace = [=](const Stage&, const Probes& probes, const TraceOrder& order) {
      Traced traced = trace_of_one(probes, order);
      for (std::vector<float>* values : {&traced.radiance, &traced.standard_error}) {
        std::ranges::transform(*values, values->begin(), [=](float x) { return static_cast<float>(near_truth) * x; });
      }
      return traced;
    };
    return Looks{probe, trace};
  };
  const Choice night = choose_for_tolerance(scene, 0.03, "", darkness(1e-17, 1e-15));
  ASSERT_TRUE(night.chosen);
  EXPECT_GT(night.dark, 0.0);
  EXPECT_EQ(night.tried.size(), 1U);
  EXPECT_FALSE(choose_for_tolerance(scene, 0.03, "orders", darkness(1e-17, 1e-12)).chosen);
  const Choice twilight = choose_for_tolerance(scene, 0.03, "orders", darkness(1e-14, 2e-14));
  EXPECT_FALSE(twilight.chosen);
  EXPECT_EQ(twilight.dark, 0.0);
}

TEST(Tolerance, ThatNothingReachesNamesTheBest) {
  const auto always = [](const Scene& scene) { return scene.render.get<int>("steps") == 192 ? 0.0 : 0.2; };
  const Choice choice = choose_for_tolerance(preset("noon"), 0.1, "march", wrong_by(always));
  EXPECT_FALSE(choice.chosen);
  ASSERT_TRUE(choice.best);
  EXPECT_EQ(choice.best->method, "march");
  EXPECT_GT(choice.best->error, 0.2);
  const auto& sweep = find_method("march")->sweep;
  const auto judged = std::ranges::count_if(sweep, [](const Quality& quality) { return quality.may_be_chosen; });
  EXPECT_EQ(choice.tried.size(), static_cast<std::size_t>(judged));
  // Noise, and interpolation between corners, err at places in the picture, where no probe would see it.
  EXPECT_LT(choice.tried.size(), sweep.size());
  for (const Tried& tried : choice.tried) {
    EXPECT_EQ(tried.quality.find("noise"), std::string::npos) << tried.quality;
    EXPECT_EQ(tried.quality.find("half"), std::string::npos) << tried.quality;
  }
}

TEST(Tolerance, HoldsTheReferencesOwnErrorAgainstIt) {
  const Choice exact = choose_for_tolerance(preset("noon"), 0.02, "", wrong_by([](const Scene&) { return 0.0; }));
  ASSERT_TRUE(exact.chosen);
  EXPECT_GT(exact.error, 0.0);
  EXPECT_EQ(exact.error, exact.reference_error);
  const Choice never = choose_for_tolerance(preset("noon"), 1e-5, "", wrong_by([](const Scene&) { return 0.0; }));
  EXPECT_FALSE(never.chosen);
}

TEST(Tolerance, OfAPictureOfSpaceNeedsNoProbe) {
  Scene scene = preset("orbit");
  scene.camera.pitch = 1.5;
  scene.camera.vertical_fov = 0.2;
  int calls = 0;
  const Choice choice = choose_for_tolerance(scene, 0.01, "", wrong_by(by_steps, &calls));
  ASSERT_TRUE(choice.chosen);
  EXPECT_EQ(choice.error, choice.reference_error);
  EXPECT_EQ(calls, 0);
}

TEST(Tolerance, GivesMethodsNoSceneThatTheyDoNotClaim) {
  const Choice choice = choose_for_tolerance(preset("twilight"), 0.01, "", wrong_by([](const Scene&) { return 0.5; }));
  for (const Tried& tried : choice.tried) {
    EXPECT_NE(tried.method, "analytic");
    EXPECT_NE(tried.method, "path-trace");
  }
}

TEST(TimeLimit, TakesTheMostAccurateThatFits) {
  // A device that takes a nanosecond a step.
  const auto error = [](const Scene& s) {
    const bool near_truth = s.render.method == "orders" && s.render.get<int>("steps") == 192;
    const bool plain = s.render.method == "march" && s.render.get<std::string>("step_distribution") == "quadratic" &&
                       s.render.get<std::string>("phase") == "media";
    return near_truth ? 0.0 : plain ? by_steps(s) : 0.4;
  };
  const TimeFunction time = [](const Stage& stage) {
    const Scene& s = stage.scene();
    const auto steps = s.render.parameters.find("steps");
    return s.render.method == "march" ? 1.0 * std::get<int>(steps->second) : 3.0;
  };
  const Choice choice = choose_for_time(preset("noon"), 40.0, "", wrong_by(error), time);
  ASSERT_TRUE(choice.chosen);
  EXPECT_EQ(choice.chosen->method, "march");
  EXPECT_EQ(choice.chosen->quality, "32");
  EXPECT_EQ(choice.ms, 32.0);
  const Choice none = choose_for_time(preset("noon"), 2.0, "", wrong_by(error), time);
  EXPECT_FALSE(none.chosen);
  ASSERT_TRUE(none.best);
  EXPECT_EQ(none.best->ms, 3.0);
}

TEST(Candidates, CostNothingForTablesThatAreMade) {
  const Scene scene = preset("noon");
  const Candidate near_truth = reference(scene, false);
  const Candidate fine = reference(scene, true);
  const auto cost_of_default = [&](const Candidate& made) {
    for (const Candidate& candidate : candidates(scene, 0.01, "orders", {made})) {
      if (candidate.quality == "default") {
        return candidate.cost;
      }
    }
    return Cost{};
  };
  EXPECT_EQ(cost_of_default(near_truth).tables, 0.0);
  EXPECT_GT(cost_of_default(fine).tables, 1e6);
  EXPECT_EQ(cost_of_default(near_truth).picture, cost_of_default(fine).picture);
}

TEST(Candidates, ForASmallPictureNeedNoTables) {
  const Scene small = preset("noon", {16, 9});
  const std::vector<Candidate> all = candidates(small, 0.1, "", {reference(small, true)});
  EXPECT_EQ(all.front().cost.tables, 0.0);
  const Scene large = preset("noon", {3840, 2160});
  EXPECT_EQ(candidates(large, 0.1, "", {reference(large, false)}).front().method, "orders");
}

TEST(Candidates, LeaveMultipleScatteringOutOfThinAirAlone) {
  const auto single = [](const Scene& scene) {
    const std::vector<Candidate> all = candidates(scene, 0.05, "march", {reference(scene, false)});
    return std::ranges::count_if(all, [](const Candidate& c) { return c.quality.ends_with("single scattering"); });
  };
  Scene thin = preset("noon");
  EXPECT_EQ(single(thin), 0);
  for (Medium& medium : thin.media) {
    for (std::size_t c = 0; c < 3; ++c) {
      medium.scattering[c] *= 0.1;
    }
  }
  EXPECT_GT(single(thin), 0);
}

TEST(Media, ThatChangeNothingAreLeftOut) {
  Scene scene = preset("noon");
  EXPECT_TRUE(leave_out_media(scene, 0.0025).reasons.empty());
  Medium trace;
  trace.name = "trace";
  trace.scattering = {1e-9, 1e-9, 1e-9};
  trace.density.scale_height = 8.0;
  scene.media.push_back(trace);
  const Lighter lighter = leave_out_media(scene, 0.0025);
  ASSERT_EQ(lighter.reasons.size(), 1U);
  EXPECT_NE(lighter.reasons[0].find("trace"), std::string::npos);
  EXPECT_EQ(lighter.stage.scene().media.size(), 3U);
  EXPECT_GT(lighter.error, 0.0);
  EXPECT_LT(lighter.error, 0.0025);
  scene.planet.refraction.emplace().medium = "trace";
  EXPECT_TRUE(leave_out_media(scene, 0.0025).reasons.empty()) << "light is bent by its density";
}

TEST(Media, ThatScatterWhereNothingElseDoesStay) {
  Scene scene = preset("noon");
  Medium high;
  high.name = "thin but alone up there";
  high.scattering = {1e-9, 1e-9, 1e-9};
  high.density.profile = DensityProfile::tent;
  high.density.center = 95.0;
  high.density.half_width = 4.0;
  scene.media = {scene.media[1], high};
  EXPECT_TRUE(leave_out_media(scene, 0.0025).reasons.empty() ||
              leave_out_media(scene, 0.0025).stage.scene().media.front().name == "aerosol");
  scene.media = {high};
  EXPECT_TRUE(leave_out_media(scene, 0.9).reasons.empty()) << "the last one always stays";
}

}  // namespace
}  // namespace airlight::choice
