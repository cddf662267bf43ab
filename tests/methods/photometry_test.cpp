// presets/earth-physical.json against what daylight measures.
//
// Ground, sun at 60 degrees, clear sky. IES daylight availability (Gillette, Pierpoint and Treado 1984; IES RP-21):
// direct normal 128 exp(-0.21 m) klx of a solar constant of 128 klx, sky 0.8 + 15.5 sqrt(sin 60) klx on the horizontal:
// 87 direct, 15 sky, 102 in all. Zenith: a few kcd/m2 at that height of the sun, by the fits to measured clear skies
// that Karayel, Navvab, Ne'eman and Selkowitz 1984 compare (Energy and Buildings 6, 283); taken here as 2 to 8.

#include "core/scene/photometry.h"

#include <cmath>

#include "core/scene/preset.h"
#include "core/scene/resolve.h"
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

// Of the sky alone on the horizontal ground: sum of luminance x sine of the elevation x solid angle, exact over a row.
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
  const std::vector<ProbeResult> sun = probe_now(scene, {{scene.sun.elevation, scene.sun.azimuth}});
  Spectrum through{};
  for (std::size_t c = 0; c < 3; ++c) {
    through[c] = scene.sun.irradiance[c] * sun.front().transmittance[c];
  }
  return bt709_luminance(through) * std::sin(scene.sun.elevation) * *white_luminance(scene.sun.unit);
}

TEST(Photometry, TheSunAboveTheAirHas128000LuxOfABlackBodyAt5772K) {
  const Scene scene = physical();
  EXPECT_EQ(scene.sun.unit, SunUnit::lux);
  EXPECT_NEAR(bt709_luminance(scene.sun.irradiance), 128000.0, 100.0);
  // Its chromaticity: BT.709 to XYZ by IEC 61966-2-1, and Krystek's fit of the Planckian locus (1985), good to 1e-4.
  const auto& [r, g, b] = scene.sun.irradiance;
  const double x = 0.4124 * r + 0.3576 * g + 0.1805 * b;
  const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const double z = 0.0193 * r + 0.1192 * g + 0.9505 * b;
  const double t = 5772.0;
  const double u =
      (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const double v =
      (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  EXPECT_NEAR(4.0 * x / (x + 15.0 * y + 3.0 * z), u, 3e-4);
  EXPECT_NEAR(6.0 * y / (x + 15.0 * y + 3.0 * z), v, 3e-4);
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
  Scene lux = physical();
  lux.sun.irradiance = {128000.0, 128000.0, 128000.0};
  Scene watts = lux;
  watts.sun.irradiance = {1361.0, 1361.0, 1361.0};
  watts.sun.unit = SunUnit::watts_per_square_metre;
  EXPECT_NEAR(sky_illuminance(watts) / sky_illuminance(lux), 1.0, 1e-5);
  EXPECT_NEAR(*white_luminance(SunUnit::watts_per_square_metre), 94.05, 0.005);
  EXPECT_FALSE(white_luminance(SunUnit::relative).has_value());
}

}  // namespace
}  // namespace airlight::test
