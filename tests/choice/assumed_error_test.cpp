// Errors that are assumed of a scene before any probe.
#include "core/choice/assumed_error.h"

#include <gtest/gtest.h>

#include "tests/choice/looks.h"
#include "tests/choice/of_scene.h"

namespace airlight::choice {
namespace {

// Errors of the default against path-trace: 17 and 82 % beside the top of the air, 8.6 % in air as high as a tenth of
// the planet. There it must be probed.
TEST(Tolerance, TheDefaultIsLookedAtWhereItsTableMayFail) {
  const Scene noon = preset("noon");
  ASSERT_TRUE(default_error(noon));
  Scene scene = noon;
  scene.camera.altitude = noon.planet.atmosphere_height;
  EXPECT_FALSE(default_error(scene));
  scene.camera.altitude = 1.0001 * noon.planet.atmosphere_height;
  EXPECT_FALSE(default_error(scene)) << "82 % off (seed 1042)";
  EXPECT_FALSE(plain_reference_error(scene)) << "1.8 % off (seed 1227)";
  scene.camera.altitude = 2.0 * noon.planet.atmosphere_height;
  EXPECT_TRUE(default_error(scene));
  scene = noon;
  scene.planet.atmosphere_height = 500.0;
  EXPECT_FALSE(default_error(scene));
  scene = noon;
  scene.sun.elevation = -0.08;
  EXPECT_FALSE(default_error(scene));
  scene.sun.elevation = -0.06;
  EXPECT_GT(*default_error(scene), *default_error(noon));
}

// Dusk is as wide as the scattering air, not as all the air: on a large planet errors of 25 % in the dark were missed
// (seed 1436).
TEST(Tolerance, TheReferenceIsLookedAtWhereNothingThatScattersIsLit) {
  const auto below = [](double altitude, double sun_elevation) {
    Scene scene = preset("noon");
    scene.sun.elevation = sun_elevation;
    for (Medium& medium : scene.media) {
      medium.density.profile = DensityProfile::constant;
      medium.density.below = altitude;
      medium.scattering = {1e-4, 1e-4, 1e-4};
    }
    return plain_reference_error(scene).has_value();
  };
  EXPECT_TRUE(below(16.0, -0.06)) << "dusk is 4.1 degrees wide";
  EXPECT_FALSE(below(16.0, -0.08));
  EXPECT_FALSE(below(2.0, -0.01)) << "dusk is 1.4 degrees wide, the table's suns stand as far apart";
}

// By the error assumed for haze the defaults are taken at 1 % without a search, but not at a tenth of that.
TEST(Tolerance, HazeIsServedAtOnce) {
  int calls = 0;
  const Looks probe = wrong_by(by_steps, &calls);
  const Scene scene = haze(kBlue, kForward);
  const Choice fine = choose_for_tolerance(scene, 0.01, "", probe);
  ASSERT_TRUE(fine.chosen);
  EXPECT_EQ(fine.chosen->quality, "default");
  EXPECT_EQ(fine.error, *default_error(scene));
  EXPECT_EQ(calls, 0);
  (void)choose_for_tolerance(scene, 0.001, "", probe);
  EXPECT_GT(calls, 0);
}

// The error of `auto` wavelengths is known and included in the bound; fewer wavelengths have to be probed.
TEST(Tolerance, KnowsTheDefaultOfSpectraAndOfTables) {
  int calls = 0;
  const Looks probe = wrong_by(by_steps, &calls);
  const std::string air = R"({"at_nm": 550, "value": 0.0125, "exponent": -4})";
  Scene scene = haze(air, kForward);
  ASSERT_TRUE(scene.spectra);
  EXPECT_EQ(choose_for_tolerance(scene, 0.03, "", probe).chosen->quality, "default");
  EXPECT_EQ(calls, 0);
  Scene channels = scene;
  channels.spectra.reset();
  EXPECT_GE(*default_error(scene), *default_error(channels) + 0.002);
  scene.sun.elevation = -0.05;
  EXPECT_TRUE(default_error(scene));
  scene.spectra->wavelengths = 24;
  EXPECT_TRUE(default_error(scene));
  scene.spectra->wavelengths = 3;  // `auto` takes six there
  EXPECT_FALSE(default_error(scene));
  const Scene table = haze(
      kBlue, R"({"function": "table", "angles_deg": [0, 20, 90, 180], "values": [1.768, 0.442, 0.01768, 0.01768]})");
  EXPECT_TRUE(default_error(table));
  EXPECT_GT(*default_error(table), *default_error(haze(kBlue, R"({"function": "rayleigh"})")))
      << "as peaked as its mean cosine says";
}

// Peaks of -0.9 and 0.95 were 2 and 35 % off (seeds 1027, 1033).
TEST(Tolerance, OfSharpAndBackwardPeaksNothingIsAssumed) {
  for (const char* g : {"0.95", "-0.6"}) {
    const Scene scene = haze(kBlue, std::string(R"({"function": "henyey-greenstein", "g": )") + g + "}");
    EXPECT_FALSE(plain_reference_error(scene)) << g;
    EXPECT_FALSE(default_error(scene)) << g;
  }
}

// Over a planet of 604 548 km at sunset the plain reference was 53 % off and confirmed renderings as wrong.
TEST(Tolerance, TheReferenceIsLookedAtWhereDuskFallsBetweenItsSuns) {
  Scene scene = preset("noon");
  scene.sun.elevation = 0.0;
  EXPECT_TRUE(plain_reference_error(scene));
  for (const double radius : {20.0, 604548.0}) {
    scene.planet.ground_radius = radius;
    EXPECT_FALSE(plain_reference_error(scene)) << radius;
  }
  scene.sun.elevation = 0.1;
  EXPECT_TRUE(plain_reference_error(scene)) << "by day it is sound";
}

}  // namespace
}  // namespace airlight::choice
