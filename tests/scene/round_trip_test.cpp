// A scene written as a preset and read again is the same scene, to the last bit.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/methods/method.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/resolve.h"
#include "tests/scene/random_preset.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

TEST(Defaults, AreThoseOfTheFormat) {
  const Scene scene = scene_from(with_one_medium(""));
  EXPECT_EQ(scene.planet.ground_radius, 6360.0);
  EXPECT_EQ(scene.planet.atmosphere_height, 100.0);
  EXPECT_EQ(scene.planet.ground_albedo, (Spectrum{0, 0, 0}));
  EXPECT_EQ(scene.media[0].scattering, (Spectrum{0, 0, 0}));
  EXPECT_EQ(scene.media[0].phase, PhaseFunction::isotropic);
  EXPECT_EQ(scene.media[0].phase_g, 0.8);
  EXPECT_DOUBLE_EQ(scene.sun.elevation, 30 * M_PI / 180);
  EXPECT_EQ(scene.sun.azimuth, 0.0);
  EXPECT_EQ(scene.sun.irradiance, (Spectrum{1, 1, 1}));
  EXPECT_EQ(scene.sun.unit, SunUnit::relative);
  EXPECT_TRUE(scene.sun.disc.visible);
  EXPECT_DOUBLE_EQ(scene.sun.disc.angular_radius, 0.2666 * M_PI / 180);
  EXPECT_EQ(scene.sun.disc.limb_darkening, 0.6);
  EXPECT_EQ(scene.sun.disc.radiance_scale, 1.0);
  EXPECT_EQ(scene.camera.altitude, 0.001);
  EXPECT_EQ(scene.camera.projection, Projection::perspective);
  EXPECT_DOUBLE_EQ(scene.camera.vertical_fov, M_PI / 3);
  EXPECT_EQ(scene.image.width, 1280);
  EXPECT_EQ(scene.image.height, 720);
  EXPECT_EQ(scene.render.method, "orders");
  EXPECT_EQ(scene.render.get<int>("steps"), 32);
  EXPECT_EQ(scene.render.get<TableSize>("transmittance_lut"), (TableSize{256, 64}));
  EXPECT_EQ(scene.render.get<double>("multiple_scattering_scale"), 1.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(scene.render.parameters.at("sun_fade")));
  EXPECT_TRUE(scene.bloom.enabled);
  EXPECT_FALSE(scene.bloom.in_exr);
  EXPECT_EQ(scene.bloom.model, BloomModel::glare);
  EXPECT_EQ(scene.bloom.threshold, 1.0);
  EXPECT_EQ(scene.bloom.intensity, 0.04);
  EXPECT_EQ(scene.bloom.levels, 5);
  EXPECT_FALSE(scene.display.exposure.has_value());
  EXPECT_EQ(scene.display.metering, Metering::picture);
  EXPECT_EQ(scene.display.compensation, 0.0);
  EXPECT_EQ(scene.display.view, "");
  EXPECT_EQ(scene.display.tonemap, ToneCurve::aces);
}

TEST(Defaults, AFisheyeSpansHalfTheSphere) {
  EXPECT_DOUBLE_EQ(scene_from(with_one_medium(R"("camera": {"projection": "fisheye"})")).camera.vertical_fov, M_PI);
}

TEST(Bloom, BecomesALayerOnlyWhenStated) {
  EXPECT_TRUE(scene_from(with_one_medium(R"("bloom": {"enabled": true})")).bloom.in_exr);
  EXPECT_FALSE(scene_from(with_one_medium(R"("bloom": {"enabled": false})")).bloom.in_exr);
  EXPECT_FALSE(scene_from(with_one_medium(R"("bloom": {"levels": 3})")).bloom.in_exr);
}

// Every value differs from its default, so that a key that is not written or not read is noticed. It is a test of its
// own since terrain excludes it.
TEST(RoundTrip, KeepsAGroundByMaps) {
  const std::string text = with_one_medium(R"(
    "planet": {"albedo_map": "/maps/earth.png", "ocean": {"wind_m_per_s": 7.5, "mask_map": "/maps/water.png"}},
    "camera": {"latitude_deg": 48.5, "longitude_deg": -123.25}, "render": {"method": "orders"})");
  const Scene scene = resolve(parse_preset(text, "test", {}), method_infos());
  ASSERT_TRUE(scene.ground && scene.ground->ocean);
  EXPECT_EQ(scene.ground->albedo_map, "/maps/earth.png");
  const Scene again = resolve(parse_preset(to_json(scene), "again", {}), method_infos());
  ASSERT_TRUE(again.ground && again.ground->ocean);
  EXPECT_EQ(again.ground->albedo_map, scene.ground->albedo_map);
  EXPECT_EQ(*again.ground->ocean, *scene.ground->ocean);
  EXPECT_EQ(again.camera.latitude, scene.camera.latitude);
  EXPECT_EQ(again.camera.longitude, scene.camera.longitude);
}

TEST(RoundTrip, KeepsEveryValue) {
  const Scene scene = scene_from(R"({
    "airlight": 1, "name": "a \"name\"\n", "description": "é \\ \u0001",
    "planet": {"radius_km": 3389.5, "atmosphere_height_km": 110.25, "ground_albedo": [0.1, 0.2, 0.3],
               "terrain": {"height_map": "/maps/heights.tif", "albedo_map": "/maps/colours.png", "width_km": 33,
                           "lowest_km": -0.5, "highest_km": 4.5, "bearing_deg": 12, "distance_km": 9, "turn_deg": -7,
                           "albedo": [0.4, 0.5, 0.6]}},
    "media": [
      {"name": "a", "scattering_per_km": [1e-7, 2e-5, 0.3], "absorption_per_km": 0.1,
       "density": {"profile": "lorentzian", "center_km": 25, "half_width_km": 5, "scale_height_km": 7},
       "phase": {"function": "schlick", "g": -0.3}},
      {"name": "b", "density": {"profile": "layers", "layers": [[0, 1], [0.1, 0.7], [12.5, 0]]}},
      {"name": "c", "density": {"profile": "tent", "center_km": 3, "half_width_km": 2}},
      {"name": "d", "density": {"profile": "constant", "below_km": 4}},
      {"name": "e", "density": {"profile": "height-fog", "base_km": 0.25, "scale_height_km": 0.125}}],
    "sun": {"elevation_deg": -12.34, "azimuth_deg": 1234.5, "irradiance": [1.5, 1.6, 1.7], "unit": "W/m2",
            "disc": {"visible": false, "angular_radius_deg": 0.31, "limb_darkening": 0.1, "radiance_scale": 3}},
    "moon": {"elevation_deg": 12.25, "azimuth_deg": -33, "phase_deg": -77.5, "distance_km": 362000,
             "bright_limb_deg": 42},
    "stars": {"magnitude_limit": 4.5}, "night_sky": {"airglow": 2, "zodiacal": 0.5, "starlight": 3,
    "light_pollution_cd_per_m2": 0.25, "lamps": "sodium"},
    "camera": {"altitude_km": 12, "julian_date": 2461120.4375, "azimuth_deg": 33.3, "pitch_deg": -7.7, "roll_deg": 181.1, "projection": "fisheye",
               "vertical_fov_deg": 123.4, "polariser": {"angle_deg": 32.5}},
    "image": {"width": 17, "height": 19},
    "render": {"method": "orders", "steps": 77, "transmittance_lut": [128, 32], "multiple_scattering_scale": 0,
               "sun_fade": {"scale": 10, "bias": 0.1}, "color": "warm"},
    "bloom": {"enabled": true, "model": "chain", "threshold": 2, "intensity": 0.5, "levels": 3},
    "display": {"exposure": 12.5, "compensation_ev": -1.5, "night_ev": 2.5, "display": "sRGB", "view": "gpu", "tonemap": "none"}
  })");
  EXPECT_EQ(scene.name, "a \"name\"\n");
  EXPECT_EQ(scene.description, "é \\ \x01");
  EXPECT_EQ(scene.media[0].density.center, 25.0);
  EXPECT_EQ(scene.media[1].density.layers[2].altitude, 12.5);
  EXPECT_EQ(scene.render.get<SunFade>("sun_fade"), (SunFade{10, 0.1}));
  EXPECT_EQ(scene.display.tonemap, ToneCurve::none);
  expect_same(scene, scene_from(to_json(scene)));
}

TEST(Moon, TakesItsPhaseFromTheSunsPlaceOrItsLitShare) {
  const auto moon = [](const char* keys) { return *scene_from(with_one_medium(keys)).moon; };
  const Moon opposite = moon(R"("sun": {"elevation_deg": -30}, "moon": {"elevation_deg": 40, "azimuth_deg": 180})");
  EXPECT_NEAR(opposite.lit.phase, 10.0 * M_PI / 180, 0.03 * M_PI / 180);
  EXPECT_NEAR(std::abs(opposite.lit.bright_limb), 0.0, 1e-9);  // the sun is nearer over the zenith
  const Moon beside = moon(R"("sun": {"elevation_deg": 0}, "moon": {"elevation_deg": 0, "azimuth_deg": 90})");
  EXPECT_NEAR(beside.lit.phase, 89.853 * M_PI / 180, 0.001 * M_PI / 180);  // as of Aristarchus
  EXPECT_NEAR(beside.lit.bright_limb, M_PI / 2, 1e-9);
  EXPECT_NEAR(moon(R"("moon": {"elevation_deg": 5, "azimuth_deg": 90, "illuminated": 0.5})").lit.phase, M_PI / 2, 1e-9);
}

TEST(RoundTrip, KeepsSpheres) {
  const Scene scene = resolve(parse_preset(with_one_medium(R"("render": {"method": "orders"}, "scene": {"spheres": [
      {"azimuth_deg": 12, "elevation_deg": -3, "distance_m": 7.5, "radius_m": 0.25, "material": "translucent",
       "albedo": [0.1, 0.2, 0.3], "scatter_strength": 5},
      {"distance_m": 3, "radius_m": 1},
      {"distance_m": 4, "radius_m": 1, "material": "chrome"}]})"),
                                           "test", {}),
                              method_infos());
  ASSERT_EQ(scene.spheres.size(), 3U);
  EXPECT_EQ(scene.spheres[0].albedo, (Spectrum{0.1, 0.2, 0.3}));
  EXPECT_EQ(scene.spheres[1].albedo, (Spectrum{0.18, 0.18, 0.18}));
  EXPECT_EQ(scene.spheres[2].material, SphereMaterial::mirror);
  expect_same(scene, resolve(parse_preset(to_json(scene), "again", {}), method_infos()));
}

TEST(RoundTrip, KeepsHowTheExposureIsMetered) {
  for (const char* word : {"auto", "day", "lock:0", "lock:12"}) {
    const Scene scene = scene_from(with_one_medium(R"("display": {"exposure": ")" + std::string(word) + "\"}"));
    EXPECT_FALSE(scene.display.exposure.has_value()) << word;
    EXPECT_EQ(metering_text(scene.display), word);
    expect_same(scene, scene_from(to_json(scene)));
  }
}

TEST(RoundTrip, KeepsEachLayoutOfACubeAndTheOctahedralMap) {
  for (const char* picture :
       {R"("camera": {"projection": "cube"}, "image": {"width": 4, "height": 24})",
        R"("camera": {"projection": "cube", "cube_layout": "strip"}, "image": {"width": 24, "height": 4})",
        R"("camera": {"projection": "cube", "cube_layout": "cross"}, "image": {"width": 12, "height": 16})",
        R"("camera": {"projection": "octahedral"}, "image": {"width": 9, "height": 9})"}) {
    const Scene scene = scene_from(with_one_medium(picture));
    EXPECT_FALSE(scene.bloom.enabled) << picture;
    expect_same(scene, scene_from(to_json(scene)));
  }
}

TEST(RoundTrip, KeepsTwoHundredRandomScenes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text = random_preset(seed, {.method = "orders"});
    ASSERT_EQ(problems_of(text), "") << text;
    const Scene scene = scene_from(text);
    const std::string json = to_json(scene);
    expect_same(scene, scene_from(json));
    EXPECT_EQ(json, to_json(scene_from(json)));
  }
}

TEST(RandomPreset, IsTheSameForASeedAndAnotherForAnother) {
  EXPECT_EQ(random_preset(7), random_preset(7));
  EXPECT_NE(random_preset(7), random_preset(8));
}

TEST(Angles, OfDegreesComeBackExactly) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5) * 720.0;
    const double radians = radians_from_degrees(degrees);
    EXPECT_EQ(radians_from_degrees(degrees_from_radians(radians)), radians) << degrees;
  }
}

TEST(Angles, AreWrittenAsTheyWereTyped) {
  for (const double degrees : {0.0, 60.0, 180.0, 0.2666, -12.34, 30.1, 89.99, 359.9, 1e-4}) {
    EXPECT_EQ(format_number(degrees_from_radians(radians_from_degrees(degrees))), format_number(degrees));
  }
}

TEST(Numbers, AreShortAndReadBackTheSame) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(1280), "1280");
  EXPECT_EQ(format_number(1e9), "1e9");
  EXPECT_EQ(format_number(-8.5e-5), "-8.5e-5");
  EXPECT_EQ(format_number(1.25e100), "1.25e100");
  EXPECT_EQ(format_number(5e-324), "5e-324");
  EXPECT_EQ(format_number(-0.0), "-0.0");
}

TEST(Description, HasEveryValueWithItsUnit) {
  const std::string text = describe(scene_from(with_one_medium(R"("name": "A sky", "camera": {"altitude_km": 2})")));
  EXPECT_NE(text.find("A sky\n"), std::string::npos);
  EXPECT_NE(text.find("radius                    6360 km\n"), std::string::npos);
  EXPECT_NE(text.find("altitude                  2 km\n"), std::string::npos);
  EXPECT_NE(text.find("elevation                 30 degrees\n"), std::string::npos);
  EXPECT_NE(text.find("density                   exponential, scale height 8 km\n"), std::string::npos);
  EXPECT_NE(text.find("disc                      visible yes, angular radius 0.2666 degrees, "), std::string::npos);
  EXPECT_NE(text.find("render\n  polarisation              yes\n  method                    orders\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("sun_fade                  absent\n"), std::string::npos);
  EXPECT_NE(text.find("width                     1280 pixels\n"), std::string::npos);
}

// Who reads what a preset is learns where its air bends no light; an index of 1 bends none.
TEST(Description, SaysHowTheAirBendsLight) {
  const auto text = [](const char* n_minus_1) {
    return describe(scene_from(with_one_medium(R"("planet": {"refraction": {"n_minus_1": )" + std::string(n_minus_1) +
                                               R"(, "scale_height_km": 8}})")));
  };
  EXPECT_NE(text("2.78e-4").find("refraction                n minus 1 0.000278, scale height 8 km\n"),
            std::string::npos);
  EXPECT_EQ(text("0").find("refraction"), std::string::npos);
}

}  // namespace
}  // namespace airlight::test
