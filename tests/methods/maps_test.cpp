// Cube maps by every method on the device, and an octahedral one: each pixel is the sky in its direction.

#include <cmath>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

TEST(Maps, EachPixelIsTheSkyInItsDirection) {
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;  // its samples are random
    }
    for (const Projection projection : {Projection::cube, Projection::octahedral}) {
      // The rays are the same for every method, and a pipeline is costly.
      if (projection == Projection::octahedral && method.info.name != "march") {
        continue;
      }
      Scene scene = with_method(earth(), method, true);
      scene.camera = {.azimuth = 0.6, .projection = projection, .cube_layout = CubeLayout::cross};
      scene.image = projection == Projection::cube ? ImageSize{9, 12} : ImageSize{6, 6};
      scene.sun.disc.visible = false;
      scene.bloom.enabled = false;
      const Rendering rendering = render_now(scene);
      const std::string what =
          std::string(method.info.name) + ", projection " + std::to_string(static_cast<int>(projection));
      expect_sound(rendering, what);
      physics::Physics p = make_physics(scene);
      int inside = 0;
      std::vector<Direction> directions;
      std::vector<const float*> pixels;
      for (int k = 0; k < scene.image.width * scene.image.height; ++k) {
        const int x = k % scene.image.width;
        const int y = k / scene.image.width;
        const auto ray = p.view_ray(p.scene.camera, projection_code(projection), x + 0.5, y + 0.5);
        EXPECT_EQ(rendering.radiance.at(x, y)[3], ray.inside ? 1.0F : 0.0F) << what;
        inside += ray.inside ? 1 : 0;
        const auto rays =
            p.pixel_rays(p.scene.planet, p.scene.camera, projection_code(projection), x + 0.5, y + 0.5, ray.direction);
        if (ray.inside && rays.count == 1) {  // not where the horizon crosses it
          const physics::vec3 d = ray.direction;
          directions.push_back(angles_of(d));
          pixels.push_back(rendering.radiance.at(x, y));
        }
      }
      EXPECT_EQ(inside, projection == Projection::cube ? 54 : 36) << what;
      EXPECT_GT(directions.size(), 20U) << what;
      const float dark = 1e-5F * static_cast<float>(greatest(rendering.radiance));
      const std::vector<float> sky = probe_picture([]() -> Executor& { return executor(); }, scene, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        EXPECT_NEAR(pixels[i][1], sky[3 * i + 1], 1e-3F * sky[3 * i + 1] + dark) << what << ", " << i;
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
