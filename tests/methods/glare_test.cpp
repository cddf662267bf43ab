// The sun's glare in pictures: its light by the point spread, round, as wide at every resolution, none where no sun is.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics/physics.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

// A black sky with the sun in the middle of 30 degrees.
Scene sun_in_the_middle(int lines) {
  Scene scene = vacuum();
  scene.sun.elevation = 45.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.vertical_fov = 30.0 * kDegree;
  scene.image = {lines, lines};
  scene.display.exposure = 1.0;
  return with_method(scene, *find_method("march"), true);
}

Rendering with_glare(const Scene& scene) {
  RenderRequest request;
  request.bloom = true;
  return render_now(scene, request);
}

// Degrees from the middle.
double angle_at(const Scene& scene, double x, double y) {
  const double middle = 0.5 * scene.image.height;
  return std::atan(std::hypot(x + 0.5 - middle, y + 0.5 - middle) / middle * std::tan(15.0 * kDegree)) / kDegree;
}

TEST(GlarePicture, IsTheSunsLightByThePointSpreadAtEveryResolution) {
  physics::Physics p{};
  for (const int lines : {45, 90, 360}) {
    const Scene scene = sun_in_the_middle(lines);
    const Rendering rendering = with_glare(scene);
    ASSERT_TRUE(rendering.bloom.has_value());
    int looked_at = 0;
    for (int y = 0; y < lines; ++y) {
      for (int x = 0; x < lines; ++x) {
        const double angle = angle_at(scene, x, y);
        if (angle > 2.0) {
          const double expected = p.glare_spread(angle * kDegree, 0.0);  // of irradiance 1
          ASSERT_NEAR(channel_of(*rendering.bloom, x, y, 1) / expected, 1.0, 0.06) << lines << ": " << angle;
          ++looked_at;
        }
      }
    }
    EXPECT_GT(looked_at, lines * lines / 2);
  }
}

// As far from the sun along the rows, the columns and the diagonals; smooth over the change from points to their sum.
TEST(GlarePicture, IsRoundAndSmooth) {
  const Scene scene = sun_in_the_middle(301);
  const RadianceImage glare = *with_glare(scene).bloom;
  physics::Physics p{};
  double last = 1e30;
  for (int away = 3; away < 150; ++away) {
    const double along = channel_of(glare, 150 + away, 150, 0);
    EXPECT_NEAR(channel_of(glare, 150, 150 - away, 0) / along, 1.0, 0.02) << away;
    const int side = static_cast<int>(std::lround(away / std::sqrt(2.0)));
    const double diagonal = angle_at(scene, 150 + side, 150 + side) * kDegree;  // not as far off to the digit
    if (diagonal > 2.0 * kDegree) {
      const double expected =
          p.glare_spread(diagonal, 0.0) / p.glare_spread(angle_at(scene, 150 + away, 150) * kDegree, 0.0);
      EXPECT_NEAR(channel_of(glare, 150 + side, 150 + side, 0) / along, expected, 0.02) << away;
    }
    EXPECT_LT(along, last) << away;
    last = along;
  }
}

// A sun cut in two by the horizon of an airless planet scatters half the light, and none once it has set.
TEST(GlarePicture, ComesFromWhatIsSeenOfTheDisc) {
  Scene scene = sun_in_the_middle(60);
  scene.camera.pitch = 0.0;
  scene.camera.altitude = 1e-6;
  const auto light_at = [&](double elevation) {
    scene.sun.elevation = elevation * kDegree;
    const Rendering rendering = with_glare(scene);
    return rendering.bloom ? channel_of(*rendering.bloom, 30, 5, 1) : 0.0;
  };
  const double whole = light_at(0.3);
  EXPECT_NEAR(light_at(0.0) / whole, 0.5, 0.05);
  EXPECT_EQ(light_at(-0.3), 0.0);
}

// Scattered in the eye, it veils the ground as it veils the sky: no edge stands where the horizon is.
TEST(GlarePicture, VeilsTheGroundAsItVeilsTheSky) {
  Scene scene = sun_in_the_middle(61);
  scene.camera.altitude = 1e-6;
  scene.sun.elevation = 1.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  const Rendering rendering = with_glare(scene);
  ASSERT_TRUE(rendering.bloom.has_value());
  for (int away = 1; away <= 30; ++away) {
    const double above = channel_of(*rendering.bloom, 30, 30 - away, 1);
    EXPECT_NEAR(channel_of(*rendering.bloom, 30, 30 + away, 1) / above, 1.0, 1e-3) << away;
  }
}

TEST(GlarePicture, IsNotOutsideAFisheyesCircle) {
  Scene scene = sun_in_the_middle(31);
  scene.camera.projection = Projection::fisheye;
  scene.camera.vertical_fov = std::numbers::pi;
  const Rendering rendering = with_glare(scene);
  ASSERT_TRUE(rendering.bloom.has_value());
  EXPECT_EQ(channel_of(*rendering.bloom, 0, 0, 1), 0.0);
  EXPECT_GT(channel_of(*rendering.bloom, 0, 15, 1), 0.0);
}

// The air takes from the glare what it takes from the disc.
TEST(GlarePicture, ComesThroughTheAir) {
  Scene scene = sun_in_the_middle(31);
  const RadianceImage above = *with_glare(scene).bloom;
  scene.media = {medium("grey", {0.0, 0.0, 0.0}, {0.1, 0.0, 0.02}, exponential(8.0))};
  const RadianceImage below = *with_glare(scene).bloom;
  const double airmass = 8.0 / std::sin(scene.sun.elevation);
  for (const auto& [c, per_km] : {std::pair<std::size_t, double>{0, 0.1}, {1, 0.0}, {2, 0.02}}) {
    EXPECT_NEAR(channel_of(below, 3, 15, c) / channel_of(above, 3, 15, c), std::exp(-per_km * airmass), 0.01) << c;
  }
}

TEST(GlarePicture, IsLeftOutWithoutASunBeforeTheCamera) {
  Scene scene = sun_in_the_middle(20);
  scene.camera.azimuth += std::numbers::pi;
  scene.camera.pitch = 0.0;
  const Rendering back = with_glare(scene);
  EXPECT_FALSE(back.bloom.has_value());
  EXPECT_TRUE(std::find(back.left_out.begin(), back.left_out.end(), "bloom: no sun before the camera") !=
              back.left_out.end());
  scene = sun_in_the_middle(20);
  scene.sun.disc.visible = false;
  EXPECT_FALSE(with_glare(scene).bloom.has_value());
}

double linear(std::uint16_t code) {  // IEC 61966-2-1
  const double y = code / 65535.0;
  return y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
}

// The tone pass computes it again by itself: what it shows is the picture and the glare that others are given.
TEST(GlarePicture, IsInTheToneCurveAsItIsInItsPicture) {
  Scene round = all_round(sun_in_the_middle(8), 0.001, 72, 36);
  for (Scene scene : {sun_in_the_middle(90), round}) {
    scene.display.tonemap = ToneCurve::clamp;
    scene.display.exposure = 0.5;
    const Rendering seen = with_glare(scene);
    ASSERT_TRUE(seen.bloom.has_value());
    RenderRequest request;
    request.bloom = true;
    request.bloom_picture = false;
    request.gpu_tone = true;
    const Rendering shown = render_now(scene, request);
    EXPECT_FALSE(shown.bloom.has_value());
    ASSERT_EQ(shown.encoded.size(), seen.radiance.rgba.size());
    int lit = 0;
    for (std::size_t i = 0; i < shown.encoded.size(); ++i) {
      const double sum =
          static_cast<double>(seen.radiance.rgba[i]) + scene.bloom.intensity * static_cast<double>(seen.bloom->rgba[i]);
      if (i % 4 != 3) {
        EXPECT_NEAR(linear(shown.encoded[i]), std::min(0.5 * sum, 1.0), 5e-5) << i;
        lit += 0.5 * sum > 1e-4 && 0.5 * sum < 1.0 ? 1 : 0;
      }
    }
    EXPECT_GT(lit, 100);
  }
}

}  // namespace
}  // namespace airlight::test
