// Bodies: things that stand free in the air, each of one matter. They are numbered through, kind after kind
// (shared/bodies.h). The first functions ask a body's kind, those below go over all bodies. Positions are from the
// camera, km, in its frame.
// The includer defines, for each kind of the list:
//   uint sphere_count();
//   SphereData sphere(uint i);

// A part of a ray; empty where from > to.
struct ShadowSpan {
  real from;
  real to;
};

#include "spheres.glsl"

uint body_count() { return sphere_count(); }

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
  for (uint i = 0u; i < body_count(); i++) {
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
  for (uint i = 0u; i < body_count(); i++) {
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
  for (uint i = 0u; i < body_count(); i++) {
    ShadowSpan span = shadow_of_body(i, origin, direction, sun);
    real dark = min(span.to, t + 0.5 * width) - max(span.from, t - 0.5 * width);
    share = share * (1.0 - clamp(dark / width, 0.0, 1.0));
  }
  return share;
}
