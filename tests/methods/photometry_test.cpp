// presets/earth-physical.json against measured daylight.
//
// Illuminance of level ground under a clear sky, sun and sky together: the fits of Janiczek and DeYoung 1987 (US Naval
// Observatory Circular 171) to measured daylight, log10 of lux by powers of the sun's elevation over 90 degrees; and at
// sunset and at the end of civil twilight the American Meteorological Society's glossary: 585 to 410 and 3.5 to 2 lux.
// A sun that is seen at the horizon stands at -0.55 degrees, one whose upper limb sets at -0.83. Measured days differ
// by a fifth in air and clouds, so do these from them. Sky at noon: IES daylight availability (Gillette, Pierpoint and
// Treado 1984; IES RP-21), 0.8 + 15.5 sqrt(sin 60) klx. Zenith: a few kcd/m2 at that height of the sun, by the fits to
// measured clear skies that Karayel, Navvab, Ne'eman and Selkowitz 1984 compare (Energy and Buildings 6, 283); taken
// here as 2 to 8.

#include "core/scene/photometry.h"

#include <array>
#include <cmath>

#include "core/render/lighting.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/spectra/colour.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

Scene physical() {
  return resolve(load_preset(std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "presets/earth-physical.json"),
                 method_infos());
}

Spectrum spectrum_of(const std::array<double, 3>& rgb) {
  return {rgb[0], rgb[1], rgb[2]};
}

// Illuminance of the sky alone on level ground: sum of luminance x sine of the elevation x solid angle, exact over a
// row.
double sky_illuminance(Scene scene) {
  scene = all_round(scene, scene.camera.altitude, 192, 96);
  scene.camera.pitch = 0.0;
  scene.sun.disc.visible = false;
  const RadianceImage image = render_now(scene).radiance;
  double sum = 0.0;
  for (int y = 0; y < image.height / 2; ++y) {
    const double upper = std::sin(std::numbers::pi * (0.5 - static_cast<double>(y) / image.height));
    const double lower = std::sin(std::numbers::pi * (0.5 - (y + 1.0) / image.height));
    for (int x = 0; x < image.width; ++x) {
      const Spectrum radiance{channel_of(image, x, y, 0), channel_of(image, x, y, 1), channel_of(image, x, y, 2)};
      sum += bt709_luminance(radiance) * (upper * upper - lower * lower) * std::numbers::pi / image.width;
    }
  }
  return sum * *white_luminance(scene.sun.unit);
}

double direct_illuminance(const Scene& scene) {
  const SunLight sun = sun_light([]() -> Executor& { return executor(); }, scene);
  return bt709_luminance(spectrum_of(sun.irradiance)) * std::sin(sun.elevation) * *white_luminance(scene.sun.unit);
}

// Lux above the air, and in the colours of a picture whose white is D65: luminance is Y of CIE 1931.
TEST(Photometry, TheSunAboveTheAirHas128000Lux) {
  const Scene scene = physical();
  EXPECT_EQ(scene.sun.unit, SunUnit::lux);
  ASSERT_TRUE(scene.spectra);
  EXPECT_EQ(scene.spectra->white, White::d65);
  EXPECT_EQ(scene.spectra->irradiance, 128000.0);
  const Rgb sun = sun_colour(band_colours(scene.spectra->sun, scene.spectra->white));
  EXPECT_NEAR(bt709_luminance(sun), 1.0, 1e-5) << "weights of four digits";
}

// Light of a black body on ground that reflects from 600 nm on, seen through no air: E sin(h) / pi times the share
// visible to an eye, by Planck's law and V(lambda) of CIE 1924 every 10 nm from 380.
TEST(Photometry, LuminanceIsPhotopic) {
  const Scene scene = resolve(parse_preset(R"({"airlight": 1, "planet": {"ground_albedo":
      {"wavelengths_nm": [360, 599.5, 600.5, 830], "values": [0, 0, 1, 1]}},
      "media": [{"name": "trace", "scattering_per_km": 1e-9, "density": {"profile": "constant", "below_km": 1}}],
      "sun": {"elevation_deg": 60, "irradiance": 128000, "unit": "lux", "spectrum": {"black_body_k": 5772}},
      "camera": {"altitude_km": 0.5}, "image": {"white": "D65"}, "render": {"wavelengths": 48}})",
                                           "test", {}),
                              method_infos());
  constexpr std::array kSeen = {4e-5,    1.2e-4,  4e-4,   1.2e-3,  4e-3,    0.0116, 0.023,  0.038,   0.06,  0.09098,
                                0.13902, 0.20802, 0.323,  0.503,   0.71,    0.862,  0.954,  0.99495, 0.995, 0.952,
                                0.87,    0.757,   0.631,  0.503,   0.381,   0.265,  0.175,  0.107,   0.061, 0.032,
                                0.017,   8.21e-3, 4.1e-3, 2.09e-3, 1.05e-3, 5.2e-4, 2.5e-4, 1.2e-4,  6e-5};
  double all = 0.0;
  double red = 0.0;
  for (std::size_t i = 0; i < kSeen.size(); ++i) {
    const double nm = 380.0 + 10.0 * static_cast<double>(i);
    const double seen = kSeen[i] * std::pow(nm, -5.0) / std::expm1(1.438777e7 / (nm * 5772.0));
    all += seen;
    red += nm > 600.0 ? seen : nm == 600.0 ? 0.5 * seen : 0.0;
  }
  const ProbeResult ground = probe_now(scene, {{-80.0 * kDegree, 0.0}}).front();
  const double expected = 128000.0 * std::sin(60.0 * kDegree) / std::numbers::pi * red / all;
  EXPECT_NEAR(bt709_luminance(spectrum_of(ground.radiance)) / expected, 1.0, 0.005);
}

struct Daylight {
  double sun_deg;    // above the air
  double lux;        // by the fits; at -0.55 theirs of 0
  double tolerance;  // relative
};

double lux_of_sun_and_sky(double sun_deg) {
  Scene scene = physical();
  scene.sun.elevation = sun_deg * kDegree;
  return sky_illuminance(scene) + (sun_deg > -0.5 ? direct_illuminance(scene) : 0.0);
}

// From noon into twilight, over three powers of ten.
TEST(Photometry, DayLightsTheGroundAsMeasuredOnesDo) {
  for (const Daylight& day : {Daylight{60.0, 103100.0, 0.1}, Daylight{30.0, 46300.0, 0.25},
                              Daylight{10.0, 11120.0, 0.3}, Daylight{-0.55, 759.0, 0.25}, Daylight{-3.0, 79.1, 0.3}}) {
    const double lux = lux_of_sun_and_sky(day.sun_deg);
    RecordProperty("lux_at_" + std::to_string(day.sun_deg), std::to_string(lux));
    EXPECT_NEAR(lux / day.lux, 1.0, day.tolerance) << day.sun_deg << ": " << lux << " lux";
  }
}

TEST(Photometry, CivilTwilightIsAsBrightAsPublished) {
  const double sunset = lux_of_sun_and_sky(-0.83);
  const double end = lux_of_sun_and_sky(-6.0);
  RecordProperty("sunset_lux", std::to_string(sunset));
  RecordProperty("end_lux", std::to_string(end));
  EXPECT_GT(sunset, 410.0);
  EXPECT_LT(sunset, 585.0);
  EXPECT_GT(end, 2.0);
  EXPECT_LT(end, 3.5);
}

TEST(Photometry, ANoonSkyLightsTheGroundAsMeasuredOnesDo) {
  const Scene scene = physical();
  ASSERT_NEAR(scene.sun.elevation, 60.0 * kDegree, 1e-9);
  const double sky = sky_illuminance(scene);
  const double direct = direct_illuminance(scene);
  RecordProperty("sky_lux", std::to_string(sky));
  RecordProperty("direct_lux", std::to_string(direct));
  EXPECT_GT(sky, 10e3);
  EXPECT_LT(sky, 20e3);
  EXPECT_GT(sky + direct, 100e3);
  EXPECT_LT(sky + direct, 110e3);
  const ProbeResult zenith = probe_now(scene, {{90.0 * kDegree, 0.0}}).front();
  const double luminance = bt709_luminance(spectrum_of(zenith.radiance)) * *white_luminance(scene.sun.unit);
  RecordProperty("zenith_cd_per_m2", std::to_string(luminance));
  EXPECT_GT(luminance, 2e3);
  EXPECT_LT(luminance, 8e3);
}

// The same sky by its irradiance in W/m2: white light of 1361 W/m2 is 128 000 lux.
TEST(Photometry, WattsAreLuxByTheEfficacyOfSunlight) {
  const Scene lux = physical();
  Scene watts = lux;
  watts.sun.irradiance = {1361.0, 1361.0, 1361.0};
  watts.spectra->irradiance = 1361.0;
  watts.sun.unit = SunUnit::watts_per_square_metre;
  EXPECT_NEAR(sky_illuminance(watts) / sky_illuminance(lux), 1.0, 1e-5);
  EXPECT_NEAR(*white_luminance(SunUnit::watts_per_square_metre), 94.05, 0.005);
  EXPECT_FALSE(white_luminance(SunUnit::relative).has_value());
}

}  // namespace
}  // namespace airlight::test
