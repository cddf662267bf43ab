// Clouds that wind has moved: the same cloud elsewhere, with the light that it had.

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/methods/cloud_scene.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

constexpr double kBase = 10.0;   // km
constexpr double kPixel = 0.05;  // km at the base
constexpr int kSide = 40;        // pixels: one period of the field

// Thin discs high above the camera, which looks straight up: a pixel is as wide at top and base to a thousandth.
// Scattered once and alike in all directions, so that a place of the cloud looks the same from wherever it is seen.
Scene under_discs() {
  Scene scene = under_level_cloud(1.0, std::sin(radians(60.0)));
  Cloud& cloud = scene.clouds.front();
  const std::shared_ptr<CloudFile> balls = field_of_balls();
  auto contents = std::make_shared<CloudFile>(*balls);
  contents->dz = 0.001;
  contents->lowest = kBase + 0.0005;
  const std::size_t plane = contents->extinction.size() / static_cast<std::size_t>(contents->nz);
  for (std::size_t at = 0; at < contents->extinction.size(); ++at) {  // even in height, as in the balls' middle
    contents->extinction[at] = 4.0F * balls->extinction[5 * plane + at % plane];
  }
  contents->identity = "discs";
  cloud.base = kBase;
  cloud.top = kBase + 0.01;
  cloud.contents = contents;
  cloud.phase_g = 0.0;
  cloud.single_scattering_albedo = 1e-3;
  scene.camera.altitude = 0.0;
  scene.camera.projection = Projection::perspective;
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = radians(90.0);
  scene.image = {kSide, kSide};
  scene.camera.vertical_fov = 2.0 * std::atan(0.5 * kSide * kPixel / kBase);
  return scene;
}

// Mean difference over the mean of the first, where the second is moved by so many pixels and both are in sight.
double difference(const RadianceImage& a, const RadianceImage& b, int right, int down) {
  double sum = 0.0;
  double all = 0.0;
  for (int y = 0; y < kSide - down; ++y) {
    for (int x = 0; x < kSide - right; ++x) {
      sum += std::abs(channel_of(a, x, y, 1) - channel_of(b, x + right, y + down, 1));
      all += channel_of(a, x, y, 1);
    }
  }
  return sum / all;
}

bool makes_light(const Rendering& rendering) {
  return std::ranges::any_of(rendering.passes, [](const PassTiming& pass) {
    return pass.name.starts_with("cloud_") &&
           (pass.name.find("sweep") != std::string::npos || pass.name.find("density") != std::string::npos ||
            pass.name.find("beam") != std::string::npos);
  });
}

// The camera looks north with its head back, so that east is to the right and north is down.
TEST(CloudWind, MovesThePictureByPixels) {
  const Scene still = under_discs();
  Scene moved = still;
  moved.clouds.front().east += kPixel;
  moved.clouds.front().north += 2.0 * kPixel;
  const Rendering first = render_now(still);
  const Rendering second = render_now(moved);
  const double after = difference(first.radiance, second.radiance, 1, 2);
  const double before = difference(first.radiance, second.radiance, 0, 0);
  std::printf("moved by pixels: %.4f off, unmoved %.4f, the other way %.4f\n", after, before,
              difference(second.radiance, first.radiance, 1, 2));
  EXPECT_LT(after, 0.01);
  EXPECT_GT(before, 0.1);
}

// A field that repeats itself looks the same a period further on.
TEST(CloudWind, APeriodFurtherIsTheSamePicture) {
  const Scene still = under_discs();
  Scene moved = still;
  moved.clouds.front().east += kSide * kPixel;
  const Rendering first = render_now(still);
  const Rendering second = render_now(moved);
  EXPECT_LT(difference(first.radiance, second.radiance, 0, 0), 1e-4);
}

// Grid and light are the same to the bit, and are not made again while the sun stays.
TEST(CloudWind, KeepsTheLightOfACloud) {
  Scene scene = under_discs();
  scene.clouds.front().contents = [&] {
    auto contents = std::make_shared<CloudFile>(*scene.clouds.front().contents);
    contents->identity = "discs that no other test has";
    return contents;
  }();
  EXPECT_TRUE(makes_light(render_now(scene)));
  scene.clouds.front().east = 0.3;
  const Rendering moved = render_now(scene);
  EXPECT_FALSE(makes_light(moved));
  scene.sun.elevation -= radians(5.0);
  EXPECT_TRUE(makes_light(render_now(scene)));
  // Alone, by a device that has never seen it elsewhere.
  scene.sun.elevation += radians(5.0);
  Executor other{DeviceOptions{}};
  const Rendering alone = render([&]() -> Executor& { return other; }, scene, {});
  EXPECT_EQ(alone.radiance.rgba, moved.radiance.rgba);
}

// A stage that takes over a grid made elsewhere has it at its own place.
TEST(CloudWind, TheGridIsTakenOver) {
  Scene scene = under_discs();
  const Stage first = ready(scene);
  scene.clouds.front().north = -0.7;
  scene.clouds.front().east = 0.4;
  const Stage next = ready(scene, first);
  const auto before = first.whole().things.clouds();
  const auto after = next.whole().things.clouds();
  EXPECT_NE(before.front(), after.front());
  EXPECT_EQ(before.front()->extinction, after.front()->extinction);
  const CloudGrid own = cloud_grid(scene.clouds.front());
  EXPECT_EQ(after.front()->south, own.south);
  EXPECT_EQ(after.front()->west, own.west);
  scene.clouds.front().north = 0.0;
  scene.clouds.front().east = 0.0;
  EXPECT_EQ(ready(scene, next).whole().things.clouds().front(), before.front());
}

}  // namespace
}  // namespace airlight::test
