#include "core/measure/view_geometry.h"

#include <cmath>

#include "core/air/scene_block.h"
#include "core/output/parallel.h"

namespace airlight::measure {
namespace {

using physics::Physics;
using physics::vec3;

// The part of a scene that the view rays read.
Scene scene_of(const Viewpoint& viewpoint, const PixelFrame& frame) {
  Scene scene;
  scene.camera = viewpoint.camera;
  scene.planet.ground_radius = viewpoint.ground_radius;
  scene.sun.elevation = viewpoint.sun_elevation;
  scene.sun.azimuth = viewpoint.sun_azimuth;
  scene.image = {.width = frame.width, .height = frame.height};
  return scene;
}

// The view rays of the shaders (shaders/physics/camera.glsl) on double.
class Looker {
 public:
  Looker(const Viewpoint& viewpoint, const PixelFrame& frame)
      : physics_(geometry_of(scene_of(viewpoint, frame))), projection_(projection_code(viewpoint.camera.projection)) {}

  Physics::ViewRay ray(double x, double y) { return physics_.view_ray(physics_.scene.camera, projection_, x, y); }

  bool meets_ground(vec3 direction) {
    return physics_.meets_ground(physics_.scene.planet, physics_.scene.camera.altitude, direction.y);
  }

  double horizon_elevation() {
    const double distance = physics_.horizon_distance(physics_.scene.planet, physics_.scene.camera.altitude);
    return -std::atan2(distance, physics_.scene.planet.ground_radius);
  }

  double sun_distance(vec3 direction) const {
    const vec3 sun = physics_.scene.sun.direction;
    return std::atan2(physics::length(cross(direction, sun)), physics::dot(direction, sun));
  }

 private:
  Physics physics_;
  physics::uint projection_ = 0;
};

double elevation_of(vec3 direction) {
  return std::atan2(direction.y, std::hypot(direction.x, direction.z));
}

Physics::ViewRay ray_of(Looker& looker, const PixelFrame& frame, int column, int row) {
  return looker.ray(frame.left + column + 0.5, frame.top + row + 0.5);
}

}  // namespace

std::optional<LookDirection> look_direction(const Viewpoint& viewpoint, const PixelFrame& frame, int column, int row) {
  Looker looker(viewpoint, frame);
  const Physics::ViewRay ray = ray_of(looker, frame, column, row);
  if (!ray.inside) return std::nullopt;
  const double azimuth = std::atan2(ray.direction.x, -ray.direction.z);
  return LookDirection{.elevation = elevation_of(ray.direction),
                       .azimuth = azimuth < 0.0 ? azimuth + 360.0 * kDegree : azimuth,
                       .sun_distance = looker.sun_distance(ray.direction)};
}

std::vector<RegionBits> classify(const Viewpoint& viewpoint, const PixelFrame& frame) {
  const auto columns = static_cast<std::size_t>(frame.columns);
  std::vector<RegionBits> regions(columns * static_cast<std::size_t>(frame.rows));
  for_row_strips(frame.rows, [&](int first, int end) {
    Looker looker(viewpoint, frame);
    const double horizon = looker.horizon_elevation();
    for (int row = first; row < end; ++row) {
      for (int column = 0; column < frame.columns; ++column) {
        const Physics::ViewRay ray = ray_of(looker, frame, column, row);
        int bits = 0;
        if (ray.inside && looker.meets_ground(ray.direction)) {
          bits = kGround;
        } else if (ray.inside) {
          const double elevation = elevation_of(ray.direction);
          bits = kSky;
          if (looker.sun_distance(ray.direction) <= kAureoleRadius) bits |= kAureole;
          if (elevation - horizon <= kHorizonBand) bits |= kHorizon;
          if (elevation >= 90.0 * kDegree - kZenithRadius) bits |= kZenith;
        }
        regions[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)] =
            static_cast<RegionBits>(bits);
      }
    }
  });
  return regions;
}

}  // namespace airlight::measure
