// Stars: their catalogue, and points whose light is kept in every picture.

#include "core/night/stars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/night/night.h"
#include "core/post/night_sky.h"
#include "core/post/stars.h"
#include "core/scene/photometry.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

double sum_magnitude(double limit) {
  double sum = 0.0;
  for (const CatalogueStar& star : bright_stars()) {
    sum += star.magnitude <= limit ? std::pow(10.0, -0.4 * star.magnitude) : 0.0;
  }
  return -2.5 * std::log10(sum);
}

// All stars to V 6 together.
TEST(StarCatalogue, AddsUp) {
  EXPECT_NEAR(sum_magnitude(6.0), -4.81, 0.05);
  EXPECT_EQ(bright_stars().size(), 8874U);
  EXPECT_NEAR(bright_stars().front().magnitude, -1.44, 0.01);  // Sirius
}

TEST(StarCatalogue, HasTheSunsTemperatureAtTheSunsColour) {
  EXPECT_NEAR(star_temperature(0.65), 5772.0, 60.0);
  EXPECT_NEAR(star_illuminance(-26.76), 128000.0, 1e-6);
}

Scene starlit(Projection projection, int width, int height) {
  Scene scene = with_method(vacuum(), *find_method("march"), true);
  scene.sun.elevation = -60.0 * kDegree;
  scene.sun.unit = SunUnit::lux;
  scene.sun.irradiance.fill(kSunlight);
  scene.stars = Stars{5.0};
  scene.camera = {.altitude = 0.01, .azimuth = 0.3, .projection = projection, .vertical_fov = std::numbers::pi};
  scene.image = {width, height};
  return scene;
}

// Illuminance of all stars more than a degree above the horizon.
double light_above(const Scene& scene, double lowest) {
  const Stage stage = ready(scene);
  double sum = 0.0;
  for (const NightStar& star : stage.night()->stars) {
    sum += star.direction.y > lowest ? star.irradiance.y : 0.0;
  }
  return sum;
}

TEST(Stars, KeepTheirLightInEverySizeAndProjection) {
  const Scene cubes[] = {starlit(Projection::equirectangular, 64, 32), starlit(Projection::equirectangular, 400, 200),
                         starlit(Projection::octahedral, 60, 60), starlit(Projection::octahedral, 300, 300),
                         starlit(Projection::cube, 40, 240)};
  for (const Scene& scene : cubes) {
    const double light = flux(scene, render_now(scene).radiance, 1);
    // A star less than a pixel above or below the horizon is shared with pixels on its other side.
    EXPECT_NEAR(light / light_above(scene, 0.0), 1.0, scene.image.width < 100 ? 0.05 : 0.02)
        << scene.image.width << " x " << scene.image.height;
  }
}

TEST(Stars, AreTheSameInTiles) {
  const Scene scene = starlit(Projection::equirectangular, 96, 48);
  RadianceImage joined;
  BandsRequest request;
  request.tile = ImageSize{32, 16};
  request.sink = [&](Band& band) {
    joined.rgba.insert(joined.rgba.end(), band.rows.radiance.rgba.begin(), band.rows.radiance.rgba.end());
  };
  render_bands([]() -> Executor& { return executor(); }, scene, request);
  EXPECT_EQ(joined.rgba, render_now(scene).radiance.rgba);
}

// A few stars in a narrow picture: the air dims each as the formulas say. The table of transmittance is up to 3 % off
// beside the horizon.
TEST(Stars, AreDimmedByTheAir) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.sun.elevation = -60.0 * kDegree;
  scene.stars = Stars{4.0};
  scene.camera = {.altitude = 0.01, .pitch = 30.0 * kDegree, .vertical_fov = 60.0 * kDegree};
  scene.image = {80, 60};
  RadianceImage with = render_now(scene).radiance;
  const Stage stage = ready(scene);
  RadianceImage formula{80, 60, std::vector<float>(with.rgba.size())};
  draw_night_sky(formula, stage, {0, 0, 80, 60});
  scene.stars.reset();
  const RadianceImage without = render_now(scene).radiance;
  int stars = 0;
  for (std::size_t i = 0; i < with.rgba.size(); ++i) {
    if (i % 4 != 3 && formula.rgba[i] > 0.0F) {
      EXPECT_NEAR(double{with.rgba[i]} - double{without.rgba[i]}, double{formula.rgba[i]},
                  0.04 * double{formula.rgba[i]});
      ++stars;
    }
  }
  EXPECT_GT(stars, 30);
}

// The table of bending against the search for each direction.
TEST(Stars, AreBentAsTheSunIs) {
  const Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/earth.json"), method_infos());
  physics::Physics p = geometry_of(scene);
  ASSERT_TRUE(p.refraction);
  const BentSky sky(p);
  for (const double elevation : {-0.5, -0.3, 0.0, 0.2, 1.0, 3.7, 12.0, 45.0, 89.0}) {
    const physics::vec3 direction = p.direction_from_angles(elevation * kDegree, 1.0);
    const SeenDirection fast = sky.seen(direction);
    const SeenDirection exact = seen_direction(p, direction);
    EXPECT_LT(physics::length(fast.direction - exact.direction) / kDegree * 3600.0, 1.0) << elevation;
    EXPECT_NEAR(fast.spread / exact.spread, 1.0, 2e-3) << elevation;
  }
}

// Orion's stars over the south in January; Jupiter stood in Taurus in 2025.
TEST(Stars, AreNamedWhereThePictureShowsThem) {
  Scene scene = starlit(Projection::fisheye, 400, 400);
  scene.camera = {.altitude = 0.01,
                  .azimuth = std::numbers::pi,
                  .pitch = 30.0 * kDegree,
                  .projection = Projection::perspective,
                  .vertical_fov = 70.0 * kDegree,
                  .latitude = 48.85 * kDegree,
                  .longitude = 2.35 * kDegree,
                  .julian_date = 2460690.42};  // 14 January 2025, 22:05
  const std::vector<NamedPoint> points = named_points(ready(scene));
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(points, [&](const NamedPoint& point) { return point.name == name; });
  };
  EXPECT_TRUE(has("Sirius"));
  EXPECT_TRUE(has("Rigel"));
  EXPECT_TRUE(has("Betelgeuse"));
  EXPECT_FALSE(has("Vega"));
  const auto sirius = std::ranges::find(points, "Sirius", &NamedPoint::name);
  ASSERT_NE(sirius, points.end());
  EXPECT_NEAR(sirius->elevation / kDegree, 22.0, 4.0);  // it culminates at 24.4, half past eleven
  EXPECT_TRUE(std::ranges::is_sorted(points, {}, &NamedPoint::magnitude));
}

TEST(Stars, HaveTheirColours) {
  const Stage stage = ready(starlit(Projection::equirectangular, 8, 4));
  // Among the brightest dozen are Rigel, blue, and Betelgeuse, red.
  const auto ratio = [&](std::size_t i) {
    const physics::vec3& light = stage.night()->stars[i].irradiance;
    return light.x / light.z;
  };
  double bluest = 1e9;
  double reddest = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    bluest = std::min(bluest, ratio(i));
    reddest = std::max(reddest, ratio(i));
  }
  EXPECT_LT(bluest, 0.8);
  EXPECT_GT(reddest, 2.0);
}

}  // namespace
}  // namespace airlight::test
