// Automatic exposure: the meter's rules, its course through dusk, and its limit.

#include <cmath>
#include <numbers>

#include "core/render/metering.h"
#include "core/scene/photometry.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

constexpr double kDay = 0.30;  // what the meter reads by day, shown

// Earth from the ground, level unless `pitch` says otherwise, by a quick method.
Scene earth_at(double sun_deg, double pitch_deg = 15.0) {
  Scene scene = with_method(earth(), *find_method("orders"), true);
  scene.sun.elevation = sun_deg * kDegree;
  scene.sun.azimuth = std::numbers::pi;
  scene.camera = {.pitch = pitch_deg * kDegree, .vertical_fov = 60.0 * kDegree};
  scene.image = {32, 18};
  return scene;
}

double exposure_of(const Scene& scene) {
  return render_now(scene).exposure;
}

// Brightness at which the picture is shown.
double shown(const Scene& scene) {
  const Rendering rendering = render_now(scene);
  return rendering.exposure * rendering.picture.metered_luminance;
}

double metered_exposure_now(const Scene& scene) {
  return metered_exposure([]() -> Executor& { return executor(); }, scene);
}

// With a light of the night the exposure goes on by the rods, at most 12 for each cd/m2; by day it is the same.
TEST(Exposure, GoesOnIntoANightWithLights) {
  const auto with_moon = [](Scene scene) {
    scene.sun.unit = SunUnit::lux;
    scene.sun.irradiance.fill(128000.0);
    scene.moon.emplace().elevation = 0.5;
    scene.moon->over_sun = moonlight(0.3, kMeanMoonDistance);
    scene.moon->irradiance.fill(0.2);
    return scene;
  };
  Scene day = earth_at(20.0);
  day.sun.unit = SunUnit::lux;
  day.sun.irradiance.fill(128000.0);
  EXPECT_NEAR(exposure_of(with_moon(day)) / exposure_of(day), 1.0, 1e-4);
  double before = exposure_of(with_moon(day));
  for (const double sun : {0.0, -5.0, -8.0, -11.0, -14.0, -30.0}) {
    const double now = exposure_of(with_moon(earth_at(sun)));
    EXPECT_GT(now, 0.999 * before) << sun;
    before = now;
  }
  EXPECT_GT(before, 1.0);
  EXPECT_LT(before, 12.2);
}

// Stops by night are added in full on a dark night and not at all by day. As dusk deepens no picture is shown brighter
// than the one before it.
TEST(Exposure, OpensUpByNightAlone) {
  Statistics seen{};
  Scene scene = earth_at(-30.0);
  scene.sun.unit = SunUnit::lux;
  scene.sun.irradiance.fill(128000.0);
  scene.night_sky = NightSky{};
  const auto gain = [&](double luminance) {
    seen.metered_luminance = luminance / luminance_of_one(scene);
    scene.display.night = 0.0;
    const double without = exposure_for(scene, seen);
    scene.display.night = 3.0;
    return exposure_for(scene, seen) / without;
  };
  EXPECT_NEAR(gain(1.9e-4), 8.0, 1e-9);
  EXPECT_NEAR(gain(0.021), 1.0, 1e-12);
  double before = 1e9;
  for (double luminance = 10.0; luminance > 1e-4; luminance *= 0.8) {
    seen.metered_luminance = luminance / luminance_of_one(scene);
    const double shown_at = luminance * exposure_for(scene, seen);
    EXPECT_LT(shown_at, before * (1.0 + 1e-9)) << luminance;
    before = shown_at;
  }
}

TEST(Exposure, ShowsADayAsACameraDoes) {
  for (const double sun : {90.0, 60.0, 30.0, 10.0}) {
    EXPECT_NEAR(shown(earth_at(sun)) / kDay, 1.0, 0.1) << sun;
  }
}

// Each step of the sun downward gives no brighter picture and no lower exposure, up to a limit that no night exceeds.
TEST(Exposure, FallsBehindAsTheSunSinksAndEnds) {
  double last_exposure = 0.0;
  double last_shown = 1.0;
  for (double sun = 10.0; sun >= -20.0; sun -= 2.0) {
    const double exposure = exposure_of(earth_at(sun));
    const double brightness = shown(earth_at(sun));
    EXPECT_GT(exposure, last_exposure) << sun;
    EXPECT_LT(brightness, last_shown) << sun;
    last_exposure = exposure;
    last_shown = brightness;
  }
  EXPECT_LT(last_shown, 1e-5);  // night is black
  Scene dark = earth_at(-20.0);
  for (Medium& medium : dark.media) {
    medium.scattering = {};
  }
  const double end = exposure_of(dark);  // without any light: the limit itself
  EXPECT_GT(end, last_exposure);
  EXPECT_LT(end, 1.02 * last_exposure);
  // 0.20 for each cd/m2, of 128 000 lux of sunlight.
  EXPECT_NEAR(end / 128000.0, 0.20, 0.02);
}

// From frame to frame of a sweep by a quarter of a degree: less than a third of a stop, even in the steepest dusk.
TEST(Exposure, IsSmoothThroughTheDusk) {
  double last = 0.0;
  for (double sun = 2.0; sun >= -9.0; sun -= 0.25) {
    const double stops = std::log2(exposure_of(earth_at(sun)));
    if (sun < 2.0) {
      EXPECT_NEAR(stops, last, 1.0 / 3.0) << sun;
    }
    last = stops;
  }
}

// Ward's curve itself, by its published constants: the least visible difference is shown equally large at any hour.
TEST(Exposure, IsWardsContrastBasedScale) {
  const auto least_seen = [](double luminance) { return 0.0594 * std::pow(1.219 + std::pow(luminance, 0.4), 2.5); };
  for (const double luminance : {1e-6, 1e-3, 1.0, 50.0, 3000.0, 1e5}) {
    Statistics statistics;
    statistics.metered_luminance = luminance;
    Scene scene = earth_at(30.0);
    scene.sun.unit = SunUnit::lux;
    const double exposure = exposure_for(scene, statistics);
    EXPECT_NEAR(exposure * least_seen(luminance) / (kDay / 3000.0 * least_seen(3000.0)), 1.0, 1e-12);
  }
}

// Below the horizon over black ground there is only a metre of air, which must not raise the exposure of the sky.
TEST(Exposure, BlackGroundDoesNotCount) {
  Scene scene = earth_at(30.0, 0.0);
  std::vector<double> found;
  for (const double albedo : {0.0, 0.001, 0.01, 0.1}) {
    scene.planet.ground_albedo = {albedo, albedo, albedo};
    found.push_back(exposure_of(scene));
  }
  for (const double exposure : found) {
    EXPECT_GT(exposure / found.back(), 1.0 / 1.5);
    EXPECT_LT(exposure / found.back(), 1.5);
  }
}

// The corners of a fisheye's picture are empty: a picture with more of them has the same exposure.
TEST(Exposure, EmptyPixelsDoNotCount) {
  Scene scene = earth_at(30.0, 90.0);
  scene.camera.projection = Projection::fisheye;
  scene.camera.vertical_fov = std::numbers::pi;
  scene.image = {32, 32};
  const double square = exposure_of(scene);
  scene.image = {96, 32};
  EXPECT_NEAR(exposure_of(scene) / square, 1.0, 1e-3);
}

// A sun in the picture is a hundred thousand times as bright as the sky, and moves the exposure by a tenth at most.
TEST(Exposure, TheSunsDiscDoesNotCount) {
  Scene scene = earth_at(30.0, 30.0);
  scene.camera.azimuth = scene.sun.azimuth;
  const double with = exposure_of(scene);
  scene.sun.disc.visible = false;
  EXPECT_NEAR(with / exposure_of(scene), 1.0, 0.1);
}

// The same scene in other units is exposed alike: factors of the sun's irradiance, and lux and W/m2 for each other.
TEST(Exposure, FollowsTheSceneNotItsUnit) {
  const Scene scene = earth_at(-4.0);
  const double one = exposure_of(scene);
  Scene other = scene;
  other.sun.irradiance = {1e4, 1e4, 1e4};
  EXPECT_NEAR(exposure_of(other) * 1e4 / one, 1.0, 1e-4);
  other.sun.unit = SunUnit::lux;
  other.sun.irradiance = {128000.0, 128000.0, 128000.0};
  EXPECT_NEAR(exposure_of(other) * 128000.0 / one, 1.0, 1e-4);
  other.sun.unit = SunUnit::watts_per_square_metre;
  other.sun.irradiance = {1361.0, 1361.0, 1361.0};
  EXPECT_NEAR(exposure_of(other) * 1361.0 / one, 1.0, 1e-4);
  other.sun.irradiance = {136.1, 136.1, 136.1};  // a tenth of the light: by day exposed ten times as much, here less
  EXPECT_LT(exposure_of(other) * 1361.0 / one, 10.0 * 0.9);
  EXPECT_GT(exposure_of(other) * 1361.0 / one, 1.0);
}

TEST(Exposure, StopsDouble) {
  Scene scene = earth_at(30.0);
  const double metered = exposure_of(scene);
  scene.display.compensation = 1.0;
  EXPECT_NEAR(exposure_of(scene) / metered, 2.0, 1e-9);
  scene.display.exposure = 3.0;
  scene.display.compensation = -2.0;
  EXPECT_DOUBLE_EQ(exposure_of(scene), 0.75);
}

// Metered separately and small, a large picture has the exposure that it has as a whole.
TEST(Exposure, MeteredApartIsThatOfThePicture) {
  Scene scene = earth_at(30.0);
  EXPECT_NEAR(metered_exposure_now(scene) / exposure_of(scene), 1.0, 1e-3);
  scene.display.compensation = 3.0;
  scene.display.exposure = 5.0;
  EXPECT_NEAR(metered_exposure_now(scene) * 8.0, 8.0 * metered_exposure_now(earth_at(30.0)), 1e-9);
  Scene cube = earth_at(30.0, 0.0);
  cube.camera.projection = Projection::cube;
  cube.image = {120, 720};  // 86 400 pixels
  EXPECT_NEAR(metered_exposure_now(cube) / exposure_of(cube), 1.0, 0.01);
}

// The day exposure of a scene does not depend on its hour.
TEST(Exposure, ADayIsTheSameAtEveryHour) {
  const double noon = metered_exposure_now(by_day(earth_at(60.0)));
  Scene night = earth_at(-30.0);
  night.sun.azimuth = 1.0;
  EXPECT_EQ(metered_exposure_now(by_day(night)), noon);
  EXPECT_NEAR(noon / exposure_of(earth_at(45.0)), 1.0, 1e-3);
}

}  // namespace
}  // namespace airlight::test
