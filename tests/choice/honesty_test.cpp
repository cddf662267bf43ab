// Tolerances are kept: random valid scenes, rendered as chosen, against a near-truth picture.
//
// AIRLIGHT_TOLERANCE=FIRST:LAST judges the scenes of these seeds instead of the few below, and writes each result to
// AIRLIGHT_TOLERANCE_LIST: what scripts/tolerance does.
#include "tests/choice/honesty.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/scene/angle.h"

namespace airlight::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr std::uint64_t kFew = 6;
#else
constexpr std::uint64_t kFew = 7;
#endif

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
    std::snprintf(text, sizeof text, "; the best at most %.3g, %.3g of it the reference's\n", h.estimated, h.known);
  } else {
    std::snprintf(text, sizeof text, "; at most %.4f, measured %.4f%s\n", h.estimated, h.measured,
                  h.missed() ? "; MISSED" : "");
  }
  return line + text;
}

TEST(Honesty, OfScenesNobodyThoughtOf) {
  std::uint64_t first = 5;
  std::uint64_t last = kFew;
  const std::string range = environment("AIRLIGHT_TOLERANCE");
  if (!range.empty()) {
    const std::size_t colon = range.find(':');
    ASSERT_NE(colon, std::string::npos) << "AIRLIGHT_TOLERANCE is not FIRST:LAST";
    first = std::stoull(range.substr(0, colon));
    last = std::stoull(range.substr(colon + 1));
  }
  const std::string list = environment("AIRLIGHT_TOLERANCE_LIST");
  Executor executor({.kept_bytes_max = std::size_t{256} << 20U});
  std::vector<int> rendered(kTolerances.size());
  std::vector<int> missed(kTolerances.size());
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const Scene scene = honesty_scene(seed);
    const std::vector<Honesty> results = judge_honesty(executor, scene, kTolerances);
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
