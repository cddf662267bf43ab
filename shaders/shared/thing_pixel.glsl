// The rays whose mean is a pixel of a picture of things.
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"


layout(scalar, set = 0, binding = 18) readonly buffer Corners { vec2 values[]; } corners;  // of the tile's blocks, row by row

const uint kEdgeSide = 4u;  // rays across a pixel with an edge or a shadow's edge
// Rays of a pixel wholly in a mirror. No two share a row or a column of 8, so that an edge along either is resolved in
// eight steps; as graphics hardware places its eight samples.
const uint kMirrorRays = 8u;
vec2 mirror_place(uint i) {
  uvec2 at = (uvec2(0x75012634u, 0x07361452u) >> (4u * i)) & 7u;
  return (vec2(at) + 0.5) / float(kMirrorRays);
}

vec3 direction_at(uvec2 pixel, vec2 place) {
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y).direction;
}

// What a pixel, which extends by `reach` from its middle, holds of bodies.
struct BodiesHeld {
  bool edge;
  bool mirror;  // in which light differs within the pixel
};

// Whether bodies leave the sun's light as it is, or wholly take it, within `width` of a place.
bool is_evenly_lit(vec3 point, float width) {
  float share = 1.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    float far = max(length(ball_of_body(i).centre - point), 1e-9);
    share = min(share, sun_past_body(i, point, scene.sun.seen, scene.sun.angular_radius + width / far));
  }
  return share <= 0.0 || share >= 1.0;
}

// Whether a ball that mirrors shows one thing within a pixel, whose middle ray then is the pixel: the sky, neither near
// the horizon nor near the sun, or ground of one colour without an edge of a shadow.
bool mirrors_evenly(BodyHit hit, vec3 direction, float reach) {
#ifdef AIRLIGHT_CLOUDS
  return false;
#else
  const float kAroundSun = 0.03;  // where its light is steep
  vec3 point = direction * hit.distance_;
  vec3 normal = body_normal(hit.which, point);
  float cosine = dot(direction, normal);
  vec3 away = direction - normal * (2.0 * cosine);
  // Of the directions that the pixel's rays go on in; a ball bends most in the plane of the ray.
  float wide = reach * (1.0 + 2.0 * hit.distance_ / (ball_of_body(hit.which).radius * max(-cosine, 0.02)));
  bool even = !has_terrain() && !has_ground_maps() && length(away - scene.sun.seen) > wide + kAroundSun;
  for (uint i = 0u; i < bodies_before(); i++) {
    vec3 to = ball_of_body(i).centre - point;
    float along = dot(to, away);
    float radius = ball_of_body(i).radius;
    float size = atan(radius, sqrt(max(dot(to, to) - radius * radius, 0.0)));
    even = even && (i == hit.which || atan(length(to - away * along), along) > size + wide);
  }
  Sight sight = sight_of(point, away);
  even = even && abs(sight.track.mu - horizon_mu(scene.planet, sight.from.h)) > wide;
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  float far = ground ? sight.before + sight.ray.length_ : 0.0;
  float width = (reach * hit.distance_ + wide * far) / max(-sight.track.mu, 1e-3);
  return even && (!ground || is_evenly_lit(point + away * far, width));
#endif
}

// `tells_even`: whether mirrors that show one thing are told from others.
BodiesHeld bodies_held(vec3 direction, float reach, bool tells_even) {
  BodiesHeld held = BodiesHeld(false, false);
  for (uint i = 0u; i < bodies_before(); i++) {
    float off = angle_from_body(i, direction);
    // Beside a body a pixel is even, within its edge it is not.
    held.edge = held.edge || (off < 0.6 * reach && off > -reach);
    held.mirror = held.mirror || (ball_of_body(i).material == kSphereMirror && off < 0.0);
  }
  if (tells_even && held.mirror && !held.edge) {
    BodyHit hit = nearest_body(vec3(0.0), direction, kNoBody);
    held.mirror = !hit.hit || !mirrors_evenly(hit, direction, reach);
  }
  return held;
}

// What the corners of a pixel see (thing_corners.comp).
struct PixelCorners {
  float nearest;   // distances of terrain, km
  float farthest;
  float least;     // shares of the sun past bodies, of ground and terrain
  float most;
};

PixelCorners corners_of(uvec2 pixel) {
  uint row = kThingBlock * tile_row() + 1u;
  uvec2 at = pixel + before_tile();
  uint first = at.y * row + at.x;
  vec2 a = corners.values[first];
  vec2 b = corners.values[first + 1u];
  vec2 c = corners.values[first + row];
  vec2 d = corners.values[first + row + 1u];
  PixelCorners of;
  of.nearest = min(min(a.x, b.x), min(c.x, d.x));
  of.farthest = max(max(a.x, b.x), max(c.x, d.x));
  of.least = min(min(a.y, b.y), min(c.y, d.y));
  of.most = max(max(a.y, b.y), max(c.y, d.y));
  return of;
}

// Whether the corners see terrain at distances too different to lie on one slope, or ground and terrain with different
// shares of the sun past bodies.
bool holds_step(PixelCorners of) { return of.farthest > 1.15 * of.nearest || of.most - of.least > 0.1; }

// Distance along the ground before which no ray of the pixel meets terrain.
float bare_before(PixelCorners of, vec3 direction, bool edge) {
  float before = edge ? 0.1 * of.nearest : of.farthest - of.nearest + terrain_shape().texel;
  return ground_distance(scene.planet, scene.camera.altitude, direction.y, max(of.nearest - before, 0.0));
}

struct ThingPixel {
  PixelRays rays;
  bool edge;     // rays stand on a grid
  bool mirror;   // they stand by mirror_place()
  uint count;
  float spread;  // angle between neighbouring rays
  float bare;    // no terrain before that distance along the ground, km
};

ThingPixel thing_pixel_of(uvec2 pixel, ViewRay view, bool tells_even) {
  ThingPixel found;
  found.rays = rays_at(pixel, view);
  found.edge = false;
  found.mirror = false;
  found.spread = 0.0;
  found.bare = 0.0;
  if (kProjection != kProjectionListed && kTiles != kTilesOfSky) {
    // Within the pixel, so as not to cross the cut of a map.
    float across = length(direction_at(pixel, vec2(0.99, 0.5)) - direction_at(pixel, vec2(0.01, 0.5)));
    float corner = length(direction_at(pixel, vec2(0.99, 0.99)) - direction_at(pixel, vec2(0.01, 0.01)));
    PixelCorners seen = corners_of(pixel);
    BodiesHeld bodies = bodies_held(view.direction, max(across, corner), tells_even);
    found.edge = view.inside && (bodies.edge || holds_step(seen));
    found.mirror = view.inside && bodies.mirror && !found.edge;
    found.bare = has_terrain() ? bare_before(seen, view.direction, found.edge || found.mirror) : 0.0;
    float rays_across = found.edge ? float(kEdgeSide) : found.mirror ? sqrt(float(kMirrorRays)) : 1.0;
    found.spread = across / (0.98 * rays_across);
  }
  found.count = found.edge ? kEdgeSide * kEdgeSide : found.mirror ? kMirrorRays : found.rays.count;
  return found;
}

ThingPixel thing_pixel(uvec2 pixel, ViewRay view) { return thing_pixel_of(pixel, view, true); }

WeightedRay ray_of_thing_pixel(uvec2 pixel, ViewRay view, ThingPixel of, uint i) {
  if (!of.edge && !of.mirror) {
    return weighted_ray(pixel, view, of.rays, i);
  }
  WeightedRay ray;
  vec2 on_grid = (vec2(float(i % kEdgeSide), float(i / kEdgeSide)) + 0.5) / float(kEdgeSide);
  ray.direction = direction_at(pixel, of.edge ? on_grid : mirror_place(i));
  ray.share = 1.0 / float(of.count);
  return ray;
}
