// Stars: their catalogue, and points whose light is kept in every picture.

#include "core/night/stars.h"

#include <cmath>
#include <numbers>

#include "core/night/night.h"
#include "core/post/night_sky.h"
#include "core/scene/photometry.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

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
