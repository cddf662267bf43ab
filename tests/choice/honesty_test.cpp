// Tolerances are kept: random valid scenes, rendered as chosen, against a near-truth picture.
//
// AIRLIGHT_TOLERANCE=FIRST:LAST judges the scenes of these seeds instead of the few below, by path-trace, whose samples
// stay in AIRLIGHT_TOLERANCE_TRUTH, and writes each result to AIRLIGHT_TOLERANCE_LIST; scripts/tolerance uses it.
// AIRLIGHT_TOLERANCE_FIT writes the data to which core/choice's assumed errors are fitted.
#include "tests/choice/honesty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/scene/angle.h"
#include "tests/choice/of_scene.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

const std::uint64_t kFew = sanitized() ? 6 : 7;

const std::vector<double> kTolerances{0.1, 0.03, 0.01};

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string line_of(std::uint64_t seed, const Scene& scene, const Honesty& h) {
  char text[240];
  std::snprintf(text, sizeof text, "%4d %7.1f %9.4g %5.3g %s\n", static_cast<int>(seed),
                degrees_from_radians(scene.sun.elevation), scene.camera.altitude, h.tolerance,
                h.refused ? "refused" : (h.method + ", " + h.quality).c_str());
  std::string line = text;
  line.pop_back();
  if (h.refused) {
    std::snprintf(text, sizeof text,
                  "; the best at most %.3g, %.3g of it the reference's; by default %.4f, noise %.4f%s\n", h.estimated,
                  h.known, h.measured, h.noise, h.refused_in_vain() ? "; IN VAIN" : "");
  } else {
    std::snprintf(text, sizeof text, "; at most %.4f, measured %.4f, noise %.4f%s\n", h.estimated, h.measured, h.noise,
                  h.missed() ? "; MISSED" : "");
  }
  return line + text;
}

struct Seeds {
  std::uint64_t first = 5;
  std::uint64_t last = kFew;
};

Seeds seeds_of(const std::string& range) {
  const std::size_t colon = range.find(':');
  return range.empty() ? Seeds{} : Seeds{std::stoull(range), std::stoull(range.substr(colon + 1))};
}

// No test: writes AIRLIGHT_TOLERANCE_FIT, the scenes of AIRLIGHT_TOLERANCE=FIRST:LAST.
TEST(Honesty, DISABLED_WhatOrdersErrs) {
  const std::string list = environment("AIRLIGHT_TOLERANCE_FIT");
  ASSERT_FALSE(list.empty());
  const Seeds seeds = seeds_of(environment("AIRLIGHT_TOLERANCE"));
  Executor executor({.kept_bytes_max = std::size_t{256} << 20U});
  for (std::uint64_t seed = seeds.first; seed < seeds.last; ++seed) {
    const Scene scene = honesty_scene(seed);
    const Traced traced = trace(scene, environment("AIRLIGHT_TOLERANCE_TRUTH"));
    if (traced.radiance.empty()) {
      continue;
    }
    const auto error_of = [&](const Scene& candidate) {
      return error_against(traced, picture_values(executor, candidate, traced.probes), 0.0);
    };
    const double plain = error_of(choice::reference(scene, false).stage.scene());
    const double by_default = error_of(with_quality(scene, *find_method("orders"), {}));
    const OpticalDepths depths = air_of(scene).depths();
    const Spectrum& albedo = scene.planet.ground_albedo;
    char text[300];
    std::snprintf(text, sizeof text, "%d %.3f %.5g %.5g %.5g %.4g %.4g %.4g %.4g %.4g %.5f %.5f %.5f\n",
                  static_cast<int>(seed), degrees_from_radians(scene.sun.elevation), scene.camera.altitude,
                  scene.planet.ground_radius, scene.planet.atmosphere_height,
                  std::max({albedo[0], albedo[1], albedo[2]}), depths.extinction, depths.scattering, depths.peaked,
                  depths.abrupt, traced.noise, plain, by_default);
    std::ofstream(list, std::ios::app) << text;
  }
}

TEST(Honesty, OfScenesNobodyThoughtOf) {
  const std::string range = environment("AIRLIGHT_TOLERANCE");
  const auto [first, last] = seeds_of(range);
  const std::string truths = environment("AIRLIGHT_TOLERANCE_TRUTH");
  const std::string list = environment("AIRLIGHT_TOLERANCE_LIST");
  Executor executor({.kept_bytes_max = std::size_t{256} << 20U});
  std::vector<int> rendered(kTolerances.size());
  std::vector<int> missed(kTolerances.size());
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const Scene scene = honesty_scene(seed);
    const Traced traced = truths.empty() ? Traced{} : trace(scene, truths);
    const std::vector<Honesty> results =
        judge_honesty(executor, scene, kTolerances, nullptr, traced.radiance.empty() ? nullptr : &traced);
    ASSERT_EQ(results.size(), kTolerances.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      rendered[i] += results[i].refused ? 0 : 1;
      missed[i] += results[i].missed() ? 1 : 0;
      if (!list.empty()) {
        std::ofstream(list, std::ios::app) << line_of(seed, scene, results[i]);
      }
      if (results[i].missed() && range.empty()) {
        ADD_FAILURE() << line_of(seed, scene, results[i]);
      }
    }
  }
  for (std::size_t i = 0; i < kTolerances.size(); ++i) {
    EXPECT_LE(missed[i], 0.01 * rendered[i]) << "at " << kTolerances[i] << " of " << rendered[i] << " rendered";
    EXPECT_GT(rendered[i], static_cast<int>(last - first) / 3) << "too many refusals at " << kTolerances[i];
  }
}

}  // namespace
}  // namespace airlight::test
