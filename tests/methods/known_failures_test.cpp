// Which of a method's known failures a scene lies in.

#include "core/methods/known_failures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/air/air.h"
#include "core/methods/method.h"
#include "tests/of_scene.h"

namespace airlight {
namespace {

constexpr const char* kGlory = "a glory sharper than the table's texels";

Medium medium_of(PhaseFunction phase, double scattering) {
  Medium medium;
  medium.scattering = {scattering, scattering, scattering};
  medium.density.profile = DensityProfile::exponential;
  medium.density.scale_height = 8.0;
  medium.phase = phase;
  return medium;
}

// Whether sky-view tells of the glory above molecules that scatter more than the haze does.
bool tells_of_glory(const Medium& haze) {
  const SkyMethod& method = *find_method("sky-view");
  Scene scene;
  scene.media = {medium_of(PhaseFunction::rayleigh, 0.03), haze};
  scene = with_quality(scene, method, {});
  const auto causes = known_failures_of(method, part_of(scene));
  return std::ranges::find(causes, kGlory) != causes.end();
}

// The molecules' own phase.g is the key's default, 0.8, and says nothing of how they scatter.
TEST(KnownFailuresOf, HazeCountsAmongMoleculesThatScatterMore) {
  ASSERT_NE(Medium{}.phase_g, 0.0);
  Medium haze = medium_of(PhaseFunction::henyey_greenstein, 0.004);
  haze.phase_g = -0.9;  // just within the region
  EXPECT_TRUE(tells_of_glory(haze));
  haze.phase_g = -0.89;
  EXPECT_FALSE(tells_of_glory(haze));
}

// A phase function by table has no g of its own.
TEST(KnownFailuresOf, ATableCountsByItsFirstMoment) {
  Medium haze = medium_of(PhaseFunction::table, 0.004);
  haze.phase_table = {
      .angles_deg = {0.0, 170.0, 175.0, 180.0}, .wavelengths_nm = {}, .rows = {{1e-4, 1e-4, 1.0, 10.0}}};
  EXPECT_TRUE(tells_of_glory(haze));
  haze.phase_table = {.angles_deg = {0.0, 5.0, 10.0, 180.0}, .wavelengths_nm = {}, .rows = {{10.0, 1.0, 1e-4, 1e-4}}};
  EXPECT_FALSE(tells_of_glory(haze));
}

}  // namespace
}  // namespace airlight
