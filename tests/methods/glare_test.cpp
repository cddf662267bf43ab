// The sun's glare in pictures: its light follows the point spread, is round, as wide at every resolution, none without
// a sun.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics/physics.h"
#include "tests/methods/glow_fixture.h"

namespace airlight::test {
namespace {

Scene sun_in_the_middle(int lines) {
  return lone_sun(lines, BloomModel::glare);
}

TEST(GlarePicture, IsTheSunsLightByThePointSpreadAtEveryResolution) {
  physics::Physics p{};
  for (const int lines : {45, 90, 360}) {
    const Scene scene = sun_in_the_middle(lines);
    const Rendering rendering = with_bloom(scene);
    ASSERT_TRUE(rendering.bloom.has_value());
    int looked_at = 0;
    for (int y = 0; y < lines; ++y) {
      for (int x = 0; x < lines; ++x) {
        const double angle = degrees_off_middle(scene, x, y);
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

// At equal distances from the sun the glare is equal along rows, columns and diagonals, and smooth over the change from
// points to their sum.
TEST(GlarePicture, IsRoundAndSmooth) {
  const Scene scene = sun_in_the_middle(301);
  const RadianceImage glare = *with_bloom(scene).bloom;
  physics::Physics p{};
  double last = 1e30;
  for (int away = 3; away < 150; ++away) {
    const double along = channel_of(glare, 150 + away, 150, 0);
    EXPECT_NEAR(channel_of(glare, 150, 150 - away, 0) / along, 1.0, 0.02) << away;
    const int side = static_cast<int>(std::lround(away / std::sqrt(2.0)));
    const double diagonal = degrees_off_middle(scene, 150 + side, 150 + side) * kDegree;  // not as far off to the digit
    if (diagonal > 2.0 * kDegree) {
      const double expected =
          p.glare_spread(diagonal, 0.0) / p.glare_spread(degrees_off_middle(scene, 150 + away, 150) * kDegree, 0.0);
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
    const Rendering rendering = with_bloom(scene);
    return rendering.bloom ? channel_of(*rendering.bloom, 30, 5, 1) : 0.0;
  };
  const double whole = light_at(0.3);
  EXPECT_NEAR(light_at(0.0) / whole, 0.5, 0.05);
  EXPECT_EQ(light_at(-0.3), 0.0);
}

// The light is scattered in the eye, so it veils ground and sky alike: no edge stands at the horizon.
TEST(GlarePicture, VeilsTheGroundAsItVeilsTheSky) {
  Scene scene = sun_in_the_middle(61);
  scene.camera.altitude = 1e-6;
  scene.sun.elevation = 1.0 * kDegree;
  scene.camera.pitch = scene.sun.elevation;
  const Rendering rendering = with_bloom(scene);
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
  const Rendering rendering = with_bloom(scene);
  ASSERT_TRUE(rendering.bloom.has_value());
  EXPECT_EQ(channel_of(*rendering.bloom, 0, 0, 1), 0.0);
  EXPECT_GT(channel_of(*rendering.bloom, 0, 15, 1), 0.0);
}

// The air attenuates the glare as it attenuates the disc.
TEST(GlarePicture, ComesThroughTheAir) {
  Scene scene = sun_in_the_middle(31);
  const RadianceImage above = *with_bloom(scene).bloom;
  scene.media = {medium("grey", {0.0, 0.0, 0.0}, {0.1, 0.0, 0.02}, exponential(8.0))};
  const RadianceImage below = *with_bloom(scene).bloom;
  const double airmass = 8.0 / std::sin(scene.sun.elevation);
  for (const auto& [c, per_km] : {std::pair<std::size_t, double>{0, 0.1}, {1, 0.0}, {2, 0.02}}) {
    EXPECT_NEAR(channel_of(below, 3, 15, c) / channel_of(above, 3, 15, c), std::exp(-per_km * airmass), 0.01) << c;
  }
}

TEST(GlarePicture, IsLeftOutWithoutASunBeforeTheCamera) {
  Scene scene = sun_in_the_middle(20);
  scene.camera.azimuth += std::numbers::pi;
  scene.camera.pitch = 0.0;
  const Rendering back = with_bloom(scene);
  EXPECT_FALSE(back.bloom.has_value());
  EXPECT_TRUE(std::find(back.left_out.begin(), back.left_out.end(), "bloom: no sun before the camera") !=
              back.left_out.end());
  scene = sun_in_the_middle(20);
  scene.sun.disc.visible = false;
  EXPECT_FALSE(with_bloom(scene).bloom.has_value());
}

TEST(GlarePicture, IsInTheToneCurveAsItIsInItsPicture) {
  expect_glow_in_tone_curve(sun_in_the_middle(90), 1e-4);
  expect_glow_in_tone_curve(all_round(sun_in_the_middle(8), 0.001, 72, 36), 1e-4);
}

}  // namespace
}  // namespace airlight::test
