// The presets that ship, by the methods that ship.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/error.h"
#include "core/methods/method.h"
#include "tests/scene/random_preset.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shipped() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(AIRLIGHT_SOURCE_DIR) / "presets")) {
    if (entry.path().extension() == ".json" && entry.path().stem() != "chart") {  // a list of presets, no preset
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

Scene load(const std::string& name) {
  return resolve(load_preset(fs::path(AIRLIGHT_SOURCE_DIR) / "presets" / (name + ".json")), method_infos());
}

TEST(Presets, AreAllThere) {
  std::set<std::string> names;
  for (const fs::path& file : shipped()) {
    names.insert(file.stem());
  }
  const std::set<std::string> expected = {"earth",         "earth-hillaire2020", "earth-noon", "earth-golden-hour",
                                          "earth-sunset",  "earth-twilight",     "earth-haze", "snow",
                                          "high-altitude", "stratosphere",       "orbit",      "mars-like",
                                          "lesson26"};
  EXPECT_TRUE(std::ranges::includes(names, expected));
}

TEST(Presets, ResolveWithoutAProblemAndRoundTrip) {
  std::set<std::string> titles;
  for (const fs::path& file : shipped()) {
    SCOPED_TRACE(file.string());
    try {
      const Scene scene = resolve(load_preset(file), method_infos());
      EXPECT_NE(scene.name, "");
      EXPECT_NE(scene.description, "");
      EXPECT_TRUE(titles.insert(scene.name).second) << "two presets named " << scene.name;
      EXPECT_EQ(scene.image.width, 1280);
      EXPECT_EQ(scene.image.height, 720);
      expect_same(scene, resolve(parse_preset(to_json(scene), "again", {}), method_infos()));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(Presets, RandomOnesResolveWithTheShippedMethods) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string text = random_preset(seed);
    EXPECT_NO_THROW(resolve(parse_preset(text, "random", {}), method_infos())) << text;
  }
}

TEST(Presets, EarthHillaire2020IsTheAirOfItsTable1) {
  const Scene earth = load("earth-hillaire2020");
  ASSERT_EQ(earth.media.size(), 3U);
  EXPECT_EQ(earth.media[0].name, "rayleigh");
  EXPECT_EQ(earth.media[0].scattering, (Spectrum{5.802e-3, 13.558e-3, 33.1e-3}));
  EXPECT_EQ(earth.media[0].density.scale_height, 8);
  EXPECT_EQ(earth.media[0].phase, PhaseFunction::rayleigh);
  EXPECT_EQ(earth.media[1].name, "aerosol");
  EXPECT_EQ(earth.media[1].scattering, (Spectrum{3.996e-3, 3.996e-3, 3.996e-3}));
  EXPECT_EQ(earth.media[1].absorption, (Spectrum{0.444e-3, 0.444e-3, 0.444e-3}));
  EXPECT_EQ(earth.media[1].density.scale_height, 1.2);
  EXPECT_EQ(earth.media[1].phase, PhaseFunction::henyey_greenstein);
  EXPECT_EQ(earth.media[1].phase_g, 0.8);
  EXPECT_EQ(earth.media[2].name, "ozone");
  EXPECT_EQ(earth.media[2].absorption, (Spectrum{0.650e-3, 1.881e-3, 0.085e-3}));
  EXPECT_EQ(earth.media[2].density.profile, DensityProfile::tent);
  EXPECT_EQ(earth.media[2].density.center, 25);
  EXPECT_EQ(earth.media[2].density.half_width, 15);
  EXPECT_EQ(earth.planet.ground_albedo, (Spectrum{0, 0, 0}));
}

TEST(Presets, HazeHasTenTimesTheAerosol) {
  const Scene earth = load("earth-hillaire2020");
  const Scene haze = load("earth-hillaire2020-haze");
  EXPECT_DOUBLE_EQ(haze.media[1].scattering[0], 10 * earth.media[1].scattering[0]);
  EXPECT_DOUBLE_EQ(haze.media[1].absorption[0], 10 * earth.media[1].absorption[0]);
}

TEST(Presets, TheHorizonIsInThePictureFromOrbit) {
  const Scene orbit = load("orbit");
  const double dip = std::acos(orbit.planet.ground_radius / (orbit.planet.ground_radius + orbit.camera.altitude));
  EXPECT_LT(std::abs(orbit.camera.pitch + dip), 0.3 * orbit.camera.vertical_fov);
}

// The lesson's constants, in its own terms.
TEST(Presets, Lesson26IsTheLessons) {
  const Scene lesson = load("lesson26");
  EXPECT_EQ(lesson.sun.irradiance, (Spectrum{20, 20, 20}));
  EXPECT_NEAR(lesson.sun.disc.angular_radius, 0.014, 1e-15);
  // The centre of the disc: mean radiance over the mean of 1 - u (1 - mu), which is 1 - u/3.
  const double solid_angle = 2 * M_PI * (1 - std::cos(0.014));
  const double centre = lesson.sun.disc.radiance_scale / solid_angle / (1 - lesson.sun.disc.limb_darkening / 3);
  EXPECT_NEAR(centre, 10, 1e-6);
  EXPECT_DOUBLE_EQ(lesson.render.get<double>("multiple_scattering_scale"), 4 * M_PI);
  EXPECT_EQ(lesson.render.get<SunFade>("sun_fade"), (SunFade{10, 0.1}));
  EXPECT_EQ(lesson.render.get<std::string>("step_distribution"), "uniform");
  EXPECT_EQ(lesson.render.get<int>("steps"), 32);
  EXPECT_EQ(lesson.planet.ground_albedo, (Spectrum{0, 0, 0}));
  EXPECT_DOUBLE_EQ(lesson.camera.vertical_fov, M_PI / 3);
  EXPECT_EQ(lesson.display.exposure, 1.0);
  EXPECT_EQ(lesson.display.view, "gpu");
  EXPECT_EQ(lesson.display.tonemap, ToneCurve::aces);
  EXPECT_EQ(lesson.bloom.model, BloomModel::chain);
  EXPECT_EQ(lesson.bloom.threshold, 1.0);
  EXPECT_EQ(lesson.bloom.intensity, 0.04);
  EXPECT_EQ(lesson.bloom.levels, 5);
}

}  // namespace
}  // namespace airlight::test
