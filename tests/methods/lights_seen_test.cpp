// Lights that others outshine are left out of pictures.

#include <algorithm>
#include <cmath>

#include "core/methods/ready.h"
#include "core/scene/angle.h"
#include "core/scene/photometry.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/stage/lights.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

Preset preset_named(const std::string& name) {
  return load_preset(std::string(AIRLIGHT_SOURCE_DIR) + "/presets/" + name + ".json");
}

// `earth` with moon and night sky, looking toward the sun's azimuth.
Scene lit_by(double sun_degrees, double moon_degrees) {
  Preset preset = preset_named("earth");
  for (const std::string& change :
       {"/sun/elevation_deg=" + std::to_string(sun_degrees), std::string("/night_sky={}"),
        R"(/moon={"azimuth_deg": 70, "phase_deg": 5, "elevation_deg": )" + std::to_string(moon_degrees) + "}",
        std::string("/image/width=32"), std::string("/image/height=18")}) {
    apply_override(preset, change);
  }
  Scene scene = resolve(preset, method_infos());
  scene.camera.azimuth = scene.sun.azimuth;
  return scene;
}

LightsSeen seen(const Scene& scene) {
  return lights_seen(ready(scene));
}

// The greatest share of a channel that is left out.
double lost(const Scene& scene) {
  RenderRequest all;
  all.tables = true;
  const RadianceImage whole = render_now(scene, all).radiance;
  const RadianceImage less = render_now(scene).radiance;
  double worst = 0.0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
    worst = std::max(worst, 1.0 - double{less.rgba[i]} / double{whole.rgba[i]});
  }
  return worst;
}

TEST(LightsSeen, ADeepTwilightIsBelowItsBound) {
  struct Case {
    const char* preset;
    double degrees;
    double least;  // of the bound
  };
  for (const Case& one :
       {Case{"mars-like", 30.0, 0.1}, Case{"mars-like", 36.0, 0.05}, Case{"earth", 21.0, 0.01},
        Case{"earth", 25.0, 1e-3}, Case{"earth-haze", 22.0, 0.0}, Case{"earth-physical", 24.0, 0.0}}) {
    SCOPED_TRACE(std::string(one.preset) + ", " + std::to_string(one.degrees));
    Preset preset = preset_named(one.preset);
    apply_override(preset, "/sun/elevation_deg=" + std::to_string(-one.degrees));
    Scene scene = all_round(resolve(preset, method_infos()), 0.002, 32, 32);
    scene.sun.azimuth = 0.0;
    const double bound = deep_twilight(ready(scene).whole().air, one.degrees * kDegree);
    const RadianceImage sky = render_now(scene).radiance;
    double brightest = 0.0;
    for (std::size_t i = 0; i < sky.rgba.size(); i += 4) {
      brightest = std::max(brightest, bt709_luminance(sky.rgba[i], sky.rgba[i + 1], sky.rgba[i + 2]));
    }
    brightest /= bt709_luminance(scene.sun.irradiance);
    EXPECT_LT(brightest, bound);
    EXPECT_GE(brightest, one.least * bound);
  }
}

TEST(LightsSeen, TheSunIsOutshoneLateAtNight) {
  const Scene night = lit_by(-32.0, 30.0);
  EXPECT_FALSE(seen(night).sun);
  EXPECT_TRUE(seen(night).others);
  EXPECT_LT(lost(night), 1e-3);
  EXPECT_TRUE(seen(lit_by(-25.0, 30.0)).sun);
  Scene high = night;
  high.camera.altitude = 6.0;
  EXPECT_TRUE(seen(high).sun);
  Scene without_glow = night;
  without_glow.night_sky->airglow = 0.0;
  EXPECT_TRUE(seen(without_glow).sun);
  Scene without_moon = night;
  without_moon.moon.reset();
  EXPECT_TRUE(seen(without_moon).sun);
}

TEST(LightsSeen, TheMoonIsOutshoneByDay) {
  const Scene day = lit_by(12.0, 25.0);
  EXPECT_TRUE(seen(day).sun);
  EXPECT_FALSE(seen(day).others);
  const double share = lost(day);
  EXPECT_GT(share, 0.0);
  EXPECT_LT(share, 1e-3);
  EXPECT_TRUE(seen(lit_by(8.0, 25.0)).others);
  Scene strong = day;
  for (double& channel : strong.moon->irradiance) {
    channel *= 20.0;
  }
  EXPECT_TRUE(seen(strong).others);
  Scene eclipsed = day;
  eclipsed.sun.uncovered = 0.01;
  EXPECT_TRUE(seen(eclipsed).others);
}

}  // namespace
}  // namespace airlight::test
