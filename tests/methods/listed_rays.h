#pragma once
// The middles of a picture's pixels as listed directions, which take each its own ray through all code, in order.

#include <vector>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {

// Red, green and blue of each pixel, rows from the top, for a perspective camera.
inline std::vector<float> listed_rays_of(const Scene& scene) {
  physics::Physics p = make_physics(scene);
  std::vector<Direction> directions;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      directions.push_back(
          angles_of(p.view_ray(p.scene.camera, physics::kProjectionPerspective, x + 0.5, y + 0.5).direction));
    }
  }
  return probe_picture([]() -> Executor& { return executor(); }, scene, directions);
}

}  // namespace airlight::test
