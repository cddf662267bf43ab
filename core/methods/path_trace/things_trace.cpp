#include "core/methods/path_trace/things_trace.h"

#include <algorithm>

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
    highest_ = terrain_->highest();
  }
  for (const physics::SphereData& sphere : spheres_) {
    highest_ = std::max(highest_, part.scene.camera.altitude + length(sphere.centre) + sphere.radius);
  }
}

std::optional<TracedThings::Met> TracedThings::hit(vec3 from, vec3 direction, double limit, ThingNumber left) const {
  std::optional<Met> first;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const double t = physics_.distance_to_sphere(spheres_[i], from - camera_, direction);
    if (t > 0.0 && t < limit && static_cast<ThingNumber>(i) != left) {
      first = Met{t, static_cast<ThingNumber>(i), from + direction * t};
      limit = t;
    }
  }
  if (terrain_) {
    if (const std::optional<double> t = terrain_->hit(from, direction, limit)) {
      first = Met{*t, kOnTerrain, from + direction * *t};
    }
  }
  return first;
}

std::optional<TracedThings::Met> TracedThings::hit(const BentWay& way, double limit, ThingNumber left) const {
  std::optional<Met> first;
  way.chords(limit, highest_, [&](const BentWay::Chord& chord) {
    first = hit(chord.from, chord.direction, chord.length, left);
    if (first) {
      first->distance = way.on_ray(chord, first->distance);
    }
    return first.has_value();
  });
  return first;
}

bool TracedThings::hides_sun(physics::Physics& physics, vec3 place, double h, const Sunbeam& beam,
                             ThingNumber left) const {
  if (!physics.refraction) {
    return hit(place, sun_, kFar, left).has_value();
  }
  const vec3 up = normalize(place);
  const vec3 to_sun = sun_seen_from(physics, place, beam);
  const physics::Physics::Ray ray = physics.ray_in_atmosphere(physics.scene.planet, h, beam.mu, beam.mu, 1.0);
  return hit(BentWay(physics, place, up, to_sun, ray), ray.length_, left).has_value();
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
