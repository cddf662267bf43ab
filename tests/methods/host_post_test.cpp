// Post-processing on the host, for a method that samples there, against the device's passes.
#include "core/post/host_post.h"

#include <cmath>

#include "core/plan/bytes.h"
#include "core/post/post.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

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
    ASSERT_TRUE(draw_sun_disc(drawn, part_of(scene), whole(scene)));
    scene.sun.disc.visible = false;
    const RadianceImage without = render_now(scene).radiance;
    const double most = greatest(drawn);
    ASSERT_GT(most, 0.0);
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i) {
      const double pass = static_cast<double>(with.rgba[i]) - static_cast<double>(without.rgba[i]);
      EXPECT_NEAR(static_cast<double>(drawn.rgba[i]), pass, 3e-3 * most) << i;
    }
    EXPECT_FALSE(draw_sun_disc(drawn, part_of(scene), whole(scene)));
  }
}

Statistics by_pass(const RadianceImage& image, const Scene& scene, bool signed_colours) {
  Plan plan;
  plan.scene_data = device_scene_bytes(air_of(scene), scene);
  const BufferId buffer = plan.add_buffer(filled_buffer("radiance", bytes_of(image.rgba)));
  const BufferId rows = add_picture_statistics(plan, picture_of(buffer, {0, 0, image.width, image.height}),
                                               brightest_metered(scene), signed_colours);
  return summarize(executor().run(plan).contents(rows), static_cast<std::uint32_t>(image.width));
}

Statistics by_host(const RadianceImage& image, const Scene& scene, bool signed_colours) {
  return summarize(row_statistics_of(image, brightest_metered(scene), signed_colours),
                   static_cast<std::uint32_t>(image.width));
}

void expect_the_same(const RadianceImage& image, const Scene& scene, bool signed_colours) {
  const Statistics host = by_host(image, scene, signed_colours);
  const Statistics pass = by_pass(image, scene, signed_colours);
  EXPECT_NEAR(host.metered_luminance, pass.metered_luminance, 1e-5 * pass.metered_luminance);
  EXPECT_NEAR(host.max_luminance, pass.max_luminance, 1e-6 * pass.max_luminance);
  EXPECT_EQ(host.not_finite, pass.not_finite);
  EXPECT_EQ(host.negative, pass.negative);
  EXPECT_EQ(host.outside, pass.outside);
  EXPECT_EQ(host.first_bad_x, pass.first_bad_x);
  EXPECT_EQ(host.first_bad_y, pass.first_bad_y);
}

TEST(HostPost, MeasuresWhatThePassMeasures) {
  Scene scene = discs().front();
  scene.image = {200, 11};  // no whole number of the pass's lanes
  scene.camera.vertical_fov = 1.0;
  RadianceImage image = render_now(scene).radiance;
  const auto pixel = [&](int x, int y) { return image.rgba.data() + 4 * (200 * y + x); };
  expect_the_same(image, scene, false);
  ASSERT_TRUE(by_host(image, scene, false).sound());
  pixel(60, 1)[3] = 0.0F;   // not metered
  pixel(61, 1)[0] = 1e30F;  // brighter than what is metered
  pixel(62, 1)[0] = 0.0F;
  pixel(62, 1)[1] = 0.0F;
  pixel(62, 1)[2] = 0.0F;
  expect_the_same(image, scene, false);
  pixel(170, 3)[0] = NAN;
  pixel(7, 4)[2] = INFINITY;
  pixel(2, 5)[1] = -1.0F;
  pixel(3, 5)[1] = -1e-6F;  // a colour outside, of positive luminance
  expect_the_same(image, scene, false);
  expect_the_same(image, scene, true);
  const Statistics found = by_host(image, scene, false);
  EXPECT_EQ(found.not_finite, 2U);
  EXPECT_EQ(found.negative, 2U);
  EXPECT_EQ(found.first_bad_x, 170U);
  EXPECT_EQ(found.first_bad_y, 3U);
  EXPECT_EQ(by_host(image, scene, true).negative, 1U);
  EXPECT_EQ(by_host(image, scene, true).outside, 2U);
}

// The mean of a long row is right, whether the host or a pass computes it.
TEST(HostPost, MeasuresLongRows) {
  const Scene scene = earth();
  RadianceImage row{16384, 1, {}};
  double weights = 0.0;
  double logs = 0.0;
  for (int x = 0; x < row.width; ++x) {
    const float value = x < row.width / 2 ? 1e-3F : 0.09F;  // so that rounding does not cancel between the two sums
    row.rgba.insert(row.rgba.end(), {value, value, value, 1.0F});
    weights += std::sqrt(static_cast<double>(value));
    logs += std::sqrt(static_cast<double>(value)) * std::log(static_cast<double>(value));
  }
  const double mean = std::exp(logs / weights);
  EXPECT_NEAR(by_host(row, scene, false).metered_luminance, mean, 1e-5 * mean);
  EXPECT_NEAR(by_pass(row, scene, false).metered_luminance, mean, 1e-5 * mean);
}

TEST(HostPost, GlaresAsThePassDoes) {
  for (Scene scene : {discs()[1], discs()[2]}) {
    scene.bloom.enabled = true;
    scene.bloom.model = BloomModel::glare;
    RenderRequest request;
    request.bloom = true;
    const Rendering rendering = render_now(scene, request);
    ASSERT_TRUE(rendering.bloom);
    const RadianceImage glare = glare_picture(scene, glare_points(part_of(scene)), whole(scene));
    ASSERT_EQ(glare.rgba.size(), rendering.bloom->rgba.size());
    for (std::size_t i = 0; i < glare.rgba.size(); ++i) {
      EXPECT_NEAR(glare.rgba[i], rendering.bloom->rgba[i], 2e-4F * std::abs(glare.rgba[i])) << i;
    }
  }
}

}  // namespace
}  // namespace airlight::test
