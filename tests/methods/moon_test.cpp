// The moon as a second light: the sky is the sum over both, each rendered as the sun's is.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/methods/ready.h"
#include "core/scene/photometry.h"
#include "core/scene/readers.h"
#include "core/stage/lights.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// Air of one medium over grey ground, by its spectrum.
Scene spectral_scene() {
  Scene scene = scene_of(clear_air(R"({"named": "air"})", R"({"elevation_deg": 25, "azimuth_deg": 40})"));
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = 60.0 * kDegree;
  return scene;
}

Moon moon_at(double elevation_deg, double azimuth_deg, double phase_deg) {
  Moon moon;
  moon.elevation = elevation_deg * kDegree;
  moon.azimuth = azimuth_deg * kDegree;
  moon.lit.phase = phase_deg * kDegree;
  moon.over_sun = moonlight(moon.lit.phase, moon.distance);
  moon.irradiance.fill(value_at(moon.over_sun, 550.0));
  return moon;
}

Scene small(Scene scene) {
  scene.image = {48, 27};
  scene.camera.azimuth = scene.sun.azimuth + 0.3;
  scene.camera.pitch = 0.3;
  return scene;
}

// The scene with its sun put out and a moon in the sun's place that sends as much.
Scene with_the_sun_as_moon(Scene scene) {
  Moon moon = moon_at(0.0, 0.0, 0.0);
  moon.elevation = scene.sun.elevation;
  moon.azimuth = scene.sun.azimuth;
  moon.irradiance = scene.sun.irradiance;
  scene.moon = moon;
  scene.sun.irradiance = {};
  scene.sun.elevation = -0.5;
  return scene;
}

TEST(Moon, InTheSunsPlaceGivesTheSunsPictureToTheBit) {
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    SCOPED_TRACE(std::string(method.info.name));
    Scene scene = with_method(small(earth()), method, true);
    scene.sun.disc.visible = false;
    const Scene other = with_the_sun_as_moon(scene);
    EXPECT_EQ(render_now(scene).radiance.rgba, render_now(other).radiance.rgba);
  }
}

TEST(Moon, WithTheSunsSpectrumGivesTheSunsPictureToTheBit) {
  Scene scene = small(spectral_scene());
  scene.spectra->wavelengths = 6;
  scene.sun.disc.visible = false;
  Scene other = scene;
  other.spectra->light = constant_curve(1.0);
  EXPECT_EQ(render_now(scene).radiance.rgba, render_now(other).radiance.rgba);
}

// With the planet's edge in view, whose pixels are averaged over rays.
void expect_sum_of_lights(Scene sun) {
  Scene both = sun;
  both.moon = moon_at(35.0, 100.0, 20.0);
  Scene moon = by_moonlight(both);
  const Stage stage = ready(both);
  moon.spectra->wavelengths = static_cast<int>(stage.basis().nodes.nm.size());
  const RadianceImage all = render_now(both).radiance;
  const RadianceImage first = render_now(sun).radiance;
  const RadianceImage second = render_now(moon).radiance;
  for (std::size_t i = 0; i < all.rgba.size(); i += 4) {
    for (std::size_t c = i; c < i + 3; ++c) {
      const double sum = double{first.rgba[c]} + double{second.rgba[c]};
      EXPECT_NEAR(double{all.rgba[c]}, sum, 2e-6 * std::abs(sum) + 1e-12);
    }
  }
}

TEST(Moon, AddsToTheSun) {
  for (const char* tabulate : {"never", "always"}) {
    SCOPED_TRACE(tabulate);
    Scene sun = with_method(small(spectral_scene()), *find_method("orders"));
    sun.sun.elevation = -8.0 * kDegree;
    sun.camera.pitch = 0.0;
    sun.render.parameters.insert_or_assign("tabulate", std::string(tabulate));
    expect_sum_of_lights(sun);
  }
}

TEST(Moon, ItsLayersAddUpToThePicture) {
  Scene scene = with_method(small(earth()), *find_method("orders"));
  scene.sun.elevation = -5.0 * kDegree;
  scene.moon = moon_at(12.0, 20.0, 30.0);
  scene.camera.azimuth = 20.0 * kDegree;
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering made = render_now(scene, request);
  bool has_moon = false;
  for (std::size_t i = 0; i < made.radiance.rgba.size() / 4; ++i) {
    double sum = 0.0;
    for (const Layer& layer : made.layers) {
      sum += layer.is_light ? double{layer.planes[i]} : 0.0;
      has_moon = has_moon || (layer.name == "moon" && layer.planes[i] > 0.0F);
    }
    EXPECT_NEAR(sum, double{made.radiance.rgba[4 * i]}, 5e-4 * sum + 1e-12);
  }
  EXPECT_TRUE(has_moon);
}

// The same bound as by day: light scattered by the very tables, by the moon's spectrum.
TEST(Moon, OrdersAgreesWithPathTrace) {
  Scene scene = spectral_scene();
  scene.sun.elevation = -30.0 * kDegree;
  scene.moon = moon_at(40.0, 0.0, 45.0);
  std::vector<Direction> directions;
  for (const double elevation : {8.0, 25.0, 60.0}) {
    for (const double azimuth : {30.0, 90.0, 150.0, 220.0}) {
      directions.push_back({elevation * kDegree, azimuth * kDegree});
    }
  }
  const std::vector<ProbeResult> orders = probe_now(with_method(scene, *find_method("orders")), directions);
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters["samples"] = 1024;
  const std::vector<ProbeResult> truth = probe_now(traced, directions);
  double sum = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::abs(orders[i].radiance[c] / truth[i].radiance[c] - 1.0);
    }
  }
  EXPECT_LT(sum / (3.0 * static_cast<double>(directions.size())), 0.02);
}

// Solid angle of a lit disc's profile by a quadrature over the ball, over the disc's.
TEST(MoonsDisc, HasTheMeanOfItsIrradianceAtEachPhase) {
  for (const double phase : {0.0, 5.0, 40.0, 90.0, 130.0, 165.0}) {
    Scene scene = vacuum();
    scene.moon = moon_at(30.0, 50.0, phase);
    const Scene lit = by_moonlight(scene);
    physics::Physics p = geometry_of(lit);
    const double radius = lit.sun.disc.angular_radius;
    const auto up = p.direction_from_angles(lit.sun.elevation + 0.5 * std::numbers::pi, lit.sun.azimuth);
    const auto side = physics::cross(up, p.scene.sun.direction);
    constexpr int kSide = 800;
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const double x = radius * (2.0 * (i + 0.5) / kSide - 1.0);
        const double y = radius * (2.0 * (j + 0.5) / kSide - 1.0);
        sum += p.lit_profile(p.scene.sun, physics::normalize(p.scene.sun.direction + side * x + up * y));
      }
    }
    EXPECT_NEAR(sum * 4.0 / (kSide * kSide) / std::numbers::pi, 1.0, 0.01) << phase;
  }
}

TEST(MoonsDisc, SendsItsIrradianceInThePicture) {
  Scene scene = with_method(vacuum(), *find_method("march"), true);
  scene.sun.elevation = -0.5;
  scene.moon = moon_at(30.0, 0.0, 70.0);
  scene.camera.pitch = 30.0 * kDegree;
  scene.camera.azimuth = 0.0;
  scene.camera.projection = Projection::perspective;
  for (const double fov : {1.0, 10.0, 50.0}) {
    scene.camera.vertical_fov = fov * kDegree;
    scene.image = {60, 60};
    EXPECT_NEAR(flux(scene, render_now(scene).radiance, 1) / scene.moon->irradiance[1], 1.0, 0.01) << fov;
  }
}

// Its bright limb to the right where it is said to be 90 degrees clockwise from the top.
TEST(MoonsDisc, IsLitOnItsBrightLimb) {
  Scene scene = with_method(vacuum(), *find_method("march"), true);
  scene.sun.elevation = -0.5;
  scene.moon = moon_at(30.0, 0.0, 90.0);
  scene.moon->lit.bright_limb = -90.0 * kDegree;
  scene.camera.pitch = 30.0 * kDegree;
  scene.camera.azimuth = 0.0;
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = 1.0 * kDegree;
  scene.image = {40, 40};
  const RadianceImage picture = render_now(scene).radiance;
  EXPECT_GT(channel_of(picture, 26, 20, 1), 1e3 * channel_of(picture, 14, 20, 1) + 1e-12);
}

// Meeus, Astronomical Algorithms, example 48.a, 12 April 1992, 0 h TT: lit share 0.6786, position angle of the bright
// limb 285.0 degrees. Its places of moon and sun, seen 45 degrees west of the meridian from 20 degrees north, give
// elevations and azimuths, the parallactic angle what is up. The rest is read off the picture's pixels.
TEST(MoonsDisc, IsLitAndTiltedAsAPublishedExampleSays) {
  constexpr double kLatitude = 20.0 * kDegree;
  constexpr double kHour = 45.0 * kDegree;
  constexpr double kMoonAscension = 134.6885 * kDegree;
  constexpr double kMoonDeclination = 13.7684 * kDegree;
  const auto seen = [&](double right_ascension, double declination) {
    const double hour = kHour + kMoonAscension - right_ascension;
    const double up =
        std::sin(kLatitude) * std::sin(declination) + std::cos(kLatitude) * std::cos(declination) * std::cos(hour);
    const double north =
        std::cos(kLatitude) * std::sin(declination) - std::sin(kLatitude) * std::cos(declination) * std::cos(hour);
    const double east = -std::cos(declination) * std::sin(hour);
    return std::pair(std::asin(up) / kDegree, std::atan2(east, north) / kDegree);
  };
  const auto [moon_up, moon_azimuth] = seen(kMoonAscension, kMoonDeclination);
  const auto [sun_up, sun_azimuth] = seen(20.6579 * kDegree, 8.6964 * kDegree);
  Preset preset = load_preset(AIRLIGHT_SOURCE_DIR "/presets/earth-hillaire2020.json");
  apply_override(preset, "/sun/elevation_deg=" + std::to_string(sun_up));
  apply_override(preset, "/sun/azimuth_deg=" + std::to_string(sun_azimuth));
  apply_override(preset, "/moon={\"elevation_deg\":" + std::to_string(moon_up) +
                             ",\"azimuth_deg\":" + std::to_string(moon_azimuth) + ",\"distance_km\":368410}");
  Scene scene = with_method(resolve(preset, method_infos()), *find_method("march"), true);
  scene.camera.pitch = moon_up * kDegree;
  scene.camera.azimuth = moon_azimuth * kDegree;
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = 1.0 * kDegree;
  scene.image = {200, 200};
  const RadianceImage picture = render_now(scene).radiance;
  float brightest = 0.0F;
  for (std::size_t i = 1; i < picture.rgba.size(); i += 4) {
    brightest = std::max(brightest, picture.rgba[i]);
  }
  double lit = 0.0;
  double x_sum = 0.0;
  double y_sum = 0.0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (channel_of(picture, x, y, 1) > 0.03 * static_cast<double>(brightest)) {
        lit += 1.0;
        x_sum += x + 0.5 - 100.0;
        y_sum += 100.0 - (y + 0.5);
      }
    }
  }
  const double radius = 200.0 * std::asin(1737.4 / 368410.0) / kDegree;
  EXPECT_NEAR(lit / (std::numbers::pi * radius * radius), 0.6786, 0.02);
  const double parallactic = std::atan2(
      std::sin(kHour), std::tan(kLatitude) * std::cos(kMoonDeclination) - std::sin(kMoonDeclination) * std::cos(kHour));
  // From straight up counter-clockwise, as position angles on the sky.
  const double tilt = std::atan2(-x_sum, y_sum) + parallactic;
  EXPECT_NEAR(std::remainder(tilt - 285.0 * kDegree, 2.0 * std::numbers::pi) / kDegree, 0.0, 1.0);
}

// The disc with its bite sends what the sky gets: the uncovered share.
TEST(Eclipse, TakesAsMuchFromTheDiscAsFromTheSky) {
  Scene scene = with_method(vacuum(), *find_method("march"), true);
  scene.sun.elevation = 30.0 * kDegree;
  scene.camera.pitch = 30.0 * kDegree;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = 1.0 * kDegree;
  scene.image = {120, 120};
  const double whole = flux(scene, render_now(scene).radiance, 1);
  const double radius = scene.sun.disc.angular_radius;
  for (const double apart : {0.3, 1.0, 1.6}) {
    Scene covered = scene;
    covered.sun.disc.cover = DiscCover{scene.sun.elevation + apart * radius, scene.sun.azimuth, 1.03 * radius};
    covered.sun.uncovered = uncovered_share(1.0, scene.sun.disc.limb_darkening, 1.03, apart);
    EXPECT_NEAR(flux(covered, render_now(covered).radiance, 1) / whole, covered.sun.uncovered, 0.01) << apart;
  }
  Scene sky = with_method(small(earth()), *find_method("orders"), true);
  sky.sun.disc.visible = false;
  const RadianceImage bright = render_now(sky).radiance;
  sky.sun.uncovered = 0.25;
  const RadianceImage dim = render_now(sky).radiance;
  for (std::size_t i = 0; i < bright.rgba.size(); i += 4) {
    EXPECT_NEAR(dim.rgba[i], 0.25F * bright.rgba[i], 1e-5F * bright.rgba[i]);
  }
}

// A full moon at 60 degrees lights the ground with 0.2 to 0.3 lux.
TEST(Moon, LightsTheGround) {
  Scene scene = with_method(spectral_scene(), *find_method("orders"));
  scene.sun.elevation = -30.0 * kDegree;
  scene.sun.unit = SunUnit::lux;
  scene.spectra->irradiance = kSunlight;
  scene.sun.irradiance.fill(kSunlight);
  scene.moon = moon_at(60.0, 0.0, 5.0);
  for (double& channel : scene.moon->irradiance) {
    channel *= kSunlight;
  }
  const Lighting lighting = lighting_of([]() -> Executor& { return executor(); }, scene, {});
  ASSERT_TRUE(lighting.moon);
  double up = 0.0;
  for (int x = 0; x < kIrradianceWidth; ++x) {
    const float* const pixel = lighting.irradiance.at(x, 0);
    up += bt709_luminance({double{pixel[0]}, double{pixel[1]}, double{pixel[2]}}) / kIrradianceWidth;
  }
  const double direct = bt709_luminance(lighting.moon->irradiance) * std::sin(60.0 * kDegree);
  EXPECT_GT(direct + up, 0.2);
  EXPECT_LT(direct + up, 0.3);
  EXPECT_GT(up, 0.05 * direct);
}

TEST(Moon, TakesOverTheSunsTablesAndAirs) {
  Scene scene = small(spectral_scene());
  scene.moon = moon_at(20.0, 0.0, 10.0);
  const unsigned int before = made_so_far().airs;
  const Stage stage = ready(scene);
  stage.parts();
  const unsigned int sun = made_so_far().airs - before;
  for (const Stage& other : stage.others()) {
    EXPECT_EQ(other.parts().size(), stage.parts().size());
  }
  EXPECT_EQ(made_so_far().airs - before, sun);
  const Plan plan = plan_for(stage, {});
  EXPECT_EQ(
      std::ranges::count_if(plan.images(), [](const ImageDesc& i) { return i.name.starts_with("transmittance"); }),
      static_cast<std::ptrdiff_t>(stage.parts().size()));
  EXPECT_EQ(std::ranges::count_if(plan.images(), [](const ImageDesc& i) { return i.name.starts_with("moments"); }),
            static_cast<std::ptrdiff_t>(stage.parts().size()));
}

}  // namespace
}  // namespace airlight::test
