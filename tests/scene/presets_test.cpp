// The shipped presets, by the shipped methods.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/scene/curve_reader.h"
#include "core/scene/density_column.h"
#include "core/spectra/data.h"
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
      EXPECT_EQ(scene.image.height, is_map(scene.camera.projection) ? 640 : 720);
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

// The density of the US Standard Atmosphere 1976 relative to that at the ground, and the optical depths above the
// ground: Rayleigh's by Bodhaine 1999, the haze's by its preset.
TEST(Presets, EarthIsTheUsStandardAtmosphere) {
  const Scene earth = load("earth");
  ASSERT_TRUE(earth.spectra);
  const Density& air = earth.media[0].density;
  ASSERT_EQ(air.profile, DensityProfile::lorentzian);
  const double scale = value_at(earth.media[0].scattering.curve, 550) / rayleigh_scattering(550);
  const std::array<std::array<double, 2>, 10> standard = {{{0, 1.2250},
                                                           {5, 0.73643},
                                                           {10, 0.41351},
                                                           {15, 0.19476},
                                                           {20, 0.088910},
                                                           {25, 0.040084},
                                                           {30, 0.018410},
                                                           {35, 0.0084634},
                                                           {40, 0.0039957},
                                                           {45, 0.0019663}}};  // km, kg/m3
  for (const auto& [h, density] : standard) {
    const double x = (air.center - h) / air.half_width;
    EXPECT_NEAR(scale * std::exp(-h / air.scale_height) / (1.0 + x * x) / (density / 1.2250), 1.0, 0.055) << h << " km";
  }
  const double top = earth.planet.atmosphere_height;
  const auto depth = [&](std::size_t i, const Curve& curve, double nm) {
    return value_at(curve, nm) * density_column(earth.media[i].density, top);
  };
  EXPECT_NEAR(depth(0, earth.media[0].scattering.curve, 500), 0.1434, 0.001);
  EXPECT_NEAR(depth(1, earth.media[1].scattering.curve, 550) + depth(1, earth.media[1].absorption.curve, 550), 0.1,
              0.005);
  // 300 DU are 3 mm of ozone; Serdyuchenko 2014 has 3.4e-21 cm2 at 550 nm and 2.687e19 molecules a cm3.
  EXPECT_NEAR(depth(2, earth.media[2].absorption.curve, 550) / (0.3 * 2.687e19 * 3.4e-21), 1.0, 0.05);
  EXPECT_NEAR(value_at(earth.planet.ground_albedo.curve, 550), 0.12, 1e-9);
}

// A preset that extends `earth` bends light by an index of its own, or not at all.
TEST(Presets, MayBendLightTheirOwnWay) {
  const auto bent = [](const std::string& refraction) {
    const std::string text =
        R"({"airlight": 1, "extends": "earth.json", "planet": {"refraction": )" + refraction + "}}";
    const fs::path presets = fs::path(AIRLIGHT_SOURCE_DIR) / "presets";
    return resolve(parse_preset(text, "own.json", presets), method_infos()).planet.refraction;
  };
  EXPECT_EQ(bent(R"({"n_minus_1": 2e-4})").value().medium, "rayleigh");
  const Refraction own = bent(R"({"n_minus_1": 2e-4, "scale_height_km": 9})").value();
  EXPECT_EQ(own.medium, "");
  EXPECT_EQ(own.density.scale_height, 9.0);
  EXPECT_FALSE(bent(R"({"n_minus_1": 0})"));
}

// All other presets have spectra too, and no curve causes a warning.
TEST(Presets, HaveSpectraButThoseThatSayOtherwise) {
  for (const fs::path& file : shipped()) {
    const std::string name = file.stem();
    const bool channels = name.starts_with("earth-hillaire2020") || name == "lesson26" ||
                          name == "planet-ocean";  // a lesson's numbers; grounds of three channels
    const Scene scene = load(name);
    EXPECT_EQ(scene.spectra.has_value(), !channels) << name;
    EXPECT_TRUE(curve_warnings(scene).empty()) << name;
  }
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
