#include "core/methods/path_trace/things_trace.h"

#include <algorithm>
#include <cmath>

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

namespace {

// Angle t between the sun and the normal of the point of a sphere of radius r that throws sunlight to a place at a
// distance d from its middle, which stands at the angle phi from the sun. Light leaves at t to the normal as it comes:
// d sin(phi - 2 t) + r sin t = 0, of which phi / 2 and phi are on either side.
double mirror_angle(double r, double d, double phi) {
  constexpr int kHalvings = 50;
  double low = 0.5 * phi;
  double high = phi;
  for (int i = 0; i < kHalvings; ++i) {
    const double t = 0.5 * (low + high);
    (d * std::sin(phi - 2.0 * t) + r * std::sin(t) > 0.0 ? low : high) = t;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<TracedThings::Thrown> TracedThings::thrown_on(vec3 place, vec3 sun, ThingNumber left) const {
  constexpr double kSlack = 1e-6;  // of the distance to the mirror
  std::vector<Thrown> all;
  for (physics::uint i = 0; i < physics_.body_count(); ++i) {
    const auto mirror = static_cast<ThingNumber>(i);
    const physics::SphereData ball = physics_.ball_of_body(i);
    const vec3 away = place - (camera_ + ball.centre);
    const double d = length(away);
    if (!mirrors(mirror) || mirror == left || d <= ball.radius) {
      continue;
    }
    const double along = dot(away, sun);
    const vec3 level = away - sun * along;
    const double t = mirror_angle(ball.radius, d, std::atan2(length(level), along));
    const double c = std::cos(t);
    if (c <= 0.0) {
      continue;  // in the sphere's own shadow
    }
    const vec3 normal = sun * c + level * (std::sin(t) / std::max(length(level), 1e-300));
    Thrown thrown{.mirror = mirror, .from = camera_ + ball.centre + normal * ball.radius};
    const vec3 way = thrown.from - place;
    thrown.distance = length(way);
    thrown.direction = way * (1.0 / thrown.distance);
    // As if from r cos t / 2 behind the mirror in the plane of the turn, and r / (2 cos t) across.
    thrown.spread = 0.25 * ball.radius * ball.radius /
                    ((thrown.distance + 0.5 * ball.radius * c) * (thrown.distance + 0.5 * ball.radius / c));
    const std::optional<Met> met = hit(place, thrown.direction, thrown.distance * (1.0 + kSlack), left);
    if (met && met->thing == mirror) {
      all.push_back(thrown);
    }
  }
  return all;
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
