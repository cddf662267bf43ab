#include "core/clouds/cloud_depth.h"

#include <algorithm>
#include <cmath>

#include "core/clouds/cloud_physics.h"

namespace airlight {

double cloud_depth(const CloudGrid& grid, double ground_radius, double h, const physics::vec3& direction) {
  constexpr double kStepRise = 0.002;  // of a step over the distance
  constexpr double kMostDepth = 50.0;
  physics::CloudPhysics p;
  physics::CloudData shell{};
  shell.base = grid.base;
  shell.top = grid.top;
  shell.width = 1.0;
  shell.depth = 1.0;
  const double shortest = 0.5 * std::min({grid.cell_x, grid.cell_y, grid.cell_z()});
  const auto ground = p.sphere_crossing(ground_radius, h, direction.y, 0.0);
  const double end = ground.from < ground.to && ground.from > 0.0 ? ground.from : 1e9;
  const auto spans = p.cloud_spans(ground_radius, shell, h, direction.y, end);
  double depth = 0.0;
  for (const auto& span : {spans.first, spans.second}) {
    for (double t = span.from; t < span.to && depth < kMostDepth;) {
      const double step = std::min(std::max(shortest, kStepRise * t), span.to - t);
      const physics::vec3 place = p.cloud_place(ground_radius, shell, h, direction, t + 0.5 * step);
      depth += step * grid.at(place.x, place.y, grid.base + place.z * (grid.top - grid.base));
      t += step;
    }
  }
  return depth;
}

double past_clouds(const std::vector<std::shared_ptr<const CloudGrid>>& clouds, const Scene& scene,
                   const physics::vec3& direction) {
  double depth = 0.0;
  for (const std::shared_ptr<const CloudGrid>& grid : clouds) {
    depth += cloud_depth(*grid, scene.planet.ground_radius, scene.camera.altitude, direction);
  }
  return std::exp(-depth);
}

}  // namespace airlight
