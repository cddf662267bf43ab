#include "core/methods/path_trace/things_trace.h"

#include <algorithm>

#include "core/air/scene_block.h"

namespace airlight {

using physics::vec3;

TracedThings::TracedThings(const Part& part)
    : physics_(geometry_of(part.scene)),
      camera_(0.0, part.scene.planet.ground_radius + part.scene.camera.altitude, 0.0),
      sun_(physics_.scene.sun.direction) {
  static_cast<physics::HostBodies&>(physics_) = part.things.bodies();
  if (part.scene.terrain) {
    terrain_.emplace(part.scene, part.things.terrain());
    highest_ = terrain_->highest();
  }
  for (physics::uint i = 0; i < physics_.body_count(); ++i) {
    const physics::SphereData ball = physics_.ball_of_body(i);
    highest_ = std::max(highest_, part.scene.camera.altitude + length(ball.centre) + ball.radius);
  }
}

std::optional<TracedThings::Met> TracedThings::hit(vec3 from, vec3 direction, double limit, ThingNumber left) const {
  std::optional<Met> first;
  const physics::Physics::BodyHit body = physics_.nearest_body(from - camera_, direction, number_of(left));
  if (body.hit && body.distance_ < limit) {
    first = Met{body.distance_, static_cast<ThingNumber>(body.which), from + direction * body.distance_};
    limit = body.distance_;
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
  return thing == kOnTerrain ? terrain_->normal(place) : physics_.body_normal(number_of(thing), place - camera_);
}

vec3 TracedThings::albedo(vec3 place, ThingNumber thing) const {
  return thing == kOnTerrain ? terrain_->albedo(place) : physics_.ball_of_body(number_of(thing)).albedo;
}

bool TracedThings::mirrors(ThingNumber thing) const {
  return thing >= 0 && physics_.ball_of_body(number_of(thing)).material == physics::kSphereMirror;
}

SurfaceShares TracedThings::shares(vec3 normal, vec3 direction, ThingNumber thing) const {
  if (thing < 0 || physics_.ball_of_body(number_of(thing)).material != physics::kSphereTranslucent) {
    return {};
  }
  // The formula takes the surface's irradiance and the mean over all normals: here they have a channel each.
  const vec3 sent = physics_.translucent_irradiance(physics_.ball_of_body(number_of(thing)), vec3(1.0, 0.0, 0.0),
                                                    vec3(0.0, 1.0, 0.0), -dot(normal, direction));
  return {sent.x, sent.y};
}

}  // namespace airlight
