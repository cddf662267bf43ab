// What follows the sky on the host, for a method that samples there, against the passes that do it on the device.
#include "core/post/host_post.h"

#include <cmath>

#include "core/methods/scene_air.h"
#include "core/post/post.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

Tile whole(const Scene& scene) {
  return {0, 0, scene.image.width, scene.image.height};
}

RadianceImage black(const Scene& scene) {
  const auto pixels = static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  return {scene.image.width, scene.image.height, std::vector<float>(4 * pixels)};
}

// A disc of many pixels half under the horizon, one smaller than a pixel, one on a panorama's seam, one on a cube.
std::vector<Scene> discs() {
  Scene low = earth();
  low.sun.elevation = 0.2 * kDegree;
  low = with_method(low, *find_method("orders"));
  low.image = {48, 32};
  low.camera = {.altitude = 0.1, .azimuth = low.sun.azimuth, .vertical_fov = 0.03};
  Scene small = low;
  small.sun.elevation = 30.0 * kDegree;
  small.camera.pitch = 0.5;
  small.camera.vertical_fov = 1.0;
  Scene seam = all_round(small, 0.1, 64, 32);
  seam.camera.azimuth = seam.sun.azimuth + 3.14159;
  Scene cube = small;
  cube.image = {16, 96};
  cube.camera = {.altitude = 0.1, .projection = Projection::cube};
  return {low, small, seam, cube};
}

TEST(HostPost, DrawsTheSunsDiscThatThePassDraws) {
  for (Scene scene : discs()) {
    const RadianceImage with = render_now(scene).radiance;
    RadianceImage drawn = black(scene);
    ASSERT_TRUE(draw_sun_disc(drawn, scene, air_of(scene), whole(scene)));
    scene.sun.disc.visible = false;
    const RadianceImage without = render_now(scene).radiance;
    const double most = greatest(drawn);
    ASSERT_GT(most, 0.0);
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i) {
      const double pass = static_cast<double>(with.rgba[i]) - static_cast<double>(without.rgba[i]);
      EXPECT_NEAR(static_cast<double>(drawn.rgba[i]), pass, 3e-3 * most) << i;
    }
    EXPECT_FALSE(draw_sun_disc(drawn, scene, air_of(scene), whole(scene)));
  }
}

TEST(HostPost, MeasuresWhatThePassMeasures) {
  Scene scene = discs().front();
  scene.camera.vertical_fov = 1.0;
  const Rendering rendering = render_now(scene);
  RadianceImage image = rendering.radiance;
  Statistics found = summarize(row_statistics_of(image, brightest_metered(scene), false), 48);
  EXPECT_NEAR(found.metered_luminance, rendering.picture.metered_luminance, 1e-4 * found.metered_luminance);
  EXPECT_NEAR(found.max_luminance, rendering.picture.max_luminance, 1e-5 * found.max_luminance);
  EXPECT_TRUE(found.sound());
  image.rgba[4 * (48 * 3 + 7)] = NAN;
  image.rgba[4 * (48 * 5 + 2) + 1] = -1.0F;
  found = summarize(row_statistics_of(image, brightest_metered(scene), false), 48);
  EXPECT_EQ(found.not_finite, 1U);
  EXPECT_EQ(found.negative, 1U);
  EXPECT_EQ(found.first_bad_x, 7U);
  EXPECT_EQ(found.first_bad_y, 3U);
  image.rgba[4 * (48 * 5 + 2) + 1] = -1e-6F;  // a colour outside, of positive luminance
  found = summarize(row_statistics_of(image, brightest_metered(scene), true), 48);
  EXPECT_EQ(found.negative, 0U);
  EXPECT_EQ(found.outside, 1U);
}

TEST(HostPost, GlaresAsThePassDoes) {
  for (Scene scene : {discs()[1], discs()[2]}) {
    scene.bloom.enabled = true;
    scene.bloom.model = BloomModel::glare;
    RenderRequest request;
    request.bloom = true;
    const Rendering rendering = render_now(scene, request);
    ASSERT_TRUE(rendering.bloom);
    const RadianceImage glare = glare_picture(scene, glare_points(scene, air_of(scene)), whole(scene));
    ASSERT_EQ(glare.rgba.size(), rendering.bloom->rgba.size());
    for (std::size_t i = 0; i < glare.rgba.size(); ++i) {
      EXPECT_NEAR(glare.rgba[i], rendering.bloom->rgba[i], 2e-4F * std::abs(glare.rgba[i])) << i;
    }
  }
}

}  // namespace
}  // namespace airlight::test
