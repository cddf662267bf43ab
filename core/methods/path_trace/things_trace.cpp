#include "core/methods/path_trace/things_trace.h"

#include "core/air/scene_block.h"

namespace airlight {

using physics::vec3;

TracedThings::TracedThings(const Part& part)
    : physics_(geometry_of(part.scene)),
      camera_(0.0, part.scene.planet.ground_radius + part.scene.camera.altitude, 0.0),
      sun_(physics_.scene.sun.direction),
      spheres_(part.things.spheres()) {
  if (part.scene.terrain) {
    terrain_.emplace(part.scene, part.things.terrain());
  }
}

std::optional<TracedThings::Met> TracedThings::hit(vec3 from, vec3 direction, double limit, ThingNumber left) const {
  std::optional<Met> first;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const double t = physics_.distance_to_sphere(spheres_[i], from - camera_, direction);
    if (t > 0.0 && t < limit && static_cast<ThingNumber>(i) != left) {
      first = Met{t, static_cast<ThingNumber>(i)};
      limit = t;
    }
  }
  if (terrain_) {
    if (const std::optional<double> t = terrain_->hit(from, direction, limit)) {
      first = Met{*t, kOnTerrain};
    }
  }
  return first;
}

vec3 TracedThings::normal(vec3 place, ThingNumber thing) const {
  return thing == kOnTerrain ? terrain_->normal(place)
                             : normalize(place - camera_ - spheres_[static_cast<std::size_t>(thing)].centre);
}

vec3 TracedThings::albedo(vec3 place, ThingNumber thing) const {
  return thing == kOnTerrain ? terrain_->albedo(place) : spheres_[static_cast<std::size_t>(thing)].albedo;
}

bool TracedThings::mirrors(ThingNumber thing) const {
  return thing >= 0 && spheres_[static_cast<std::size_t>(thing)].material == physics::kSphereMirror;
}

}  // namespace airlight
