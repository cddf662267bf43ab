// Bodies: things that stand free in the air, each of one matter. They are numbered through, kind after kind
// (shared/bodies.h). The first functions ask a body's kind, those below go over all bodies. Positions are from the
// camera, km, in its frame.
// The includer defines, for each kind of the list:
//   uint sphere_count();
//   SphereData sphere(uint i);
//   bool bodies_stand_aside();  of all rays that it asks about

// A part of a ray; empty where from > to.
struct ShadowSpan {
  real from;
  real to;
};

#include "spheres.glsl"

uint body_count() { return sphere_count(); }

// Of those that rays may meet, or whose shadow they may cross.
uint bodies_before() { return bodies_stand_aside() ? 0u : body_count(); }

// The ball around a body, of its matter. What the body hides of the sky and sends there is taken as the ball's.
SphereData ball_of_body(uint i) { return sphere(i); }

// Distance along a ray to where it enters the body; negative where it misses it.
real distance_to_body(uint i, vec3 origin, vec3 direction) { return distance_to_sphere(sphere(i), origin, direction); }

// At a point of its surface.
vec3 body_normal(uint i, vec3 point) { return normalize(point - sphere(i).centre); }

// Share of the sun's disc that the body leaves at a point.
real sun_past_body(uint i, vec3 point, vec3 sun, real sun_radius) {
  return sun_past_sphere(sphere(i), point, sun, sun_radius);
}

// The part of a ray in the body's shadow.
ShadowSpan shadow_of_body(uint i, vec3 origin, vec3 direction, vec3 sun) {
  return shadow_of_sphere(sphere(i), origin, direction, sun);
}

// Angle from the nearest edge of the body, as the camera sees it, to a direction; below 0 within.
real angle_from_body(uint i, vec3 direction) { return angle_from_sphere(sphere(i), direction); }

struct BodyHit {
  bool hit;
  uint which;
  real distance_;  // km
};

// The nearest body but `skip`, which the ray leaves.
BodyHit nearest_body(vec3 origin, vec3 direction, uint skip) {
  BodyHit nearest;
  nearest.hit = false;
  nearest.which = kNoBody;
  nearest.distance_ = 0.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    real t = distance_to_body(i, origin, direction);
    bool nearer = i != skip && t > 0.0 && (!nearest.hit || t < nearest.distance_);
    nearest.hit = nearest.hit || nearer;
    nearest.which = nearer ? i : nearest.which;
    nearest.distance_ = nearer ? t : nearest.distance_;
  }
  return nearest;
}

// Share of the sun's disc that all bodies leave but `skip`, on which the point lies.
real sun_past_bodies(vec3 point, vec3 sun, real sun_radius, uint skip) {
  real share = 1.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    share = share * (i == skip ? 1.0 : sun_past_body(i, point, sun, sun_radius));
  }
  return share;
}

// Share of the sun over a step of a ray with its middle at t; at that point where the step has no width.
real bodies_sunlit(vec3 origin, vec3 direction, vec3 sun, real sun_radius, real t, real width) {
  if (width <= 0.0) {
    return sun_past_bodies(origin + direction * t, sun, sun_radius, kNoBody);
  }
  real share = 1.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    ShadowSpan span = shadow_of_body(i, origin, direction, sun);
    real dark = min(span.to, t + 0.5 * width) - max(span.from, t - 0.5 * width);
    share = share * (1.0 - clamp(dark / width, 0.0, 1.0));
  }
  return share;
}

// Length of the shadow of the ball around a body up to where all of it lies below the ground, km; kEndless where it
// does not, or where the ground's curve counts. `fall`: sine of the sun's elevation over the body.
const real kEndless = 1e9;

real shadow_length(PlanetData planet, real highest, real fall, real sun_radius) {
  real drop = fall - 1.1 * sun_radius;
  real level = highest / max(drop, 1e-9);
  return drop > 0.0 && level * level < 0.02 * planet.ground_radius * highest ? 1.05 * level : kEndless;
}

// Angle from a direction to the shortest way from one other to a second.
real angle_from_arc(vec3 direction, vec3 from, vec3 to) {
  vec3 aside = to - from * dot(from, to);
  aside = aside / max(length(aside), 1e-12);
  real x = dot(direction, from);
  real y = dot(direction, aside);
  real place = atan(y, x);
  bool between = place > 0.0 && place < atan(dot(to, aside), dot(to, from));
  real ends = min(angle_between(direction, from), angle_between(direction, to));
  real root = sqrt(x * x + y * y);
  return between ? atan(abs(dot(direction, cross(from, aside))), root) : ends;
}

// Whether all rays from the camera within `wide` of a direction pass a body by, and its shadow. Seen from there, the
// shadow runs along a great circle from the body to the point opposite the sun or to where it enters the ground. It
// widens by the sun's radius: at a distance s behind a ball of radius r, which is c away, it is r + a s wide and looks
// at most (r + a c) / d wide, where d is the distance of its axis.
bool stands_aside(PlanetData planet, real camera_altitude, uint i, vec3 direction, real wide, SunData sun) {
  SphereData ball = ball_of_body(i);
  Place place = place_at(planet, camera_altitude, ball.centre);
  real end = shadow_length(planet, max(place.h, 0.0) + ball.radius, dot(sun.seen, place.up), sun.angular_radius);
  real nearest = clamp(dot(ball.centre, sun.seen), 0.0, end);
  real axis = length(ball.centre - sun.seen * nearest);
  real half_width = 1.1 * (ball.radius + sun.angular_radius * length(ball.centre)) / max(axis, 1e-12);
  vec3 to = end < kEndless ? normalize(ball.centre - sun.seen * end) : -sun.seen;
  real off = angle_from_arc(direction, normalize(ball.centre), to);
  return half_width < 0.7 && off > wide + atan(half_width, sqrt(1.0 - half_width * half_width));
}
