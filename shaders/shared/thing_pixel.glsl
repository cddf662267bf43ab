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

ViewRay camera_ray(uvec2 pixel, vec2 place) {
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y);
}

vec3 direction_at(uvec2 pixel, vec2 place) { return camera_ray(pixel, place).direction; }

// What a pixel, which extends by `reach` from its middle, holds of bodies.
struct BodiesHeld {
  bool edge;
  bool mirror;  // in which light differs within the pixel
};

// Whether a ball that mirrors shows one thing within a pixel, whose middle ray then is the pixel: the sky, neither near
// the horizon nor near the sun, or ground of one colour without an edge of a shadow. Clouds come from a map that is no
// finer than the pixels (cloud_map.glsl).
bool mirrors_evenly(BodyHit hit, vec3 direction, float reach) {
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
}

BodiesHeld bodies_held(vec3 direction, float reach) {
  BodiesHeld held = BodiesHeld(false, false);
  for (uint i = 0u; i < bodies_before(); i++) {
    float off = angle_from_body(i, direction);
    // Beside a body a pixel is even, within its edge it is not.
    held.edge = held.edge || (off < 0.6 * reach && off > -reach);
    held.mirror = held.mirror || (ball_of_body(i).material == kSphereMirror && off < 0.0);
  }
  if (held.mirror && !held.edge) {
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

// A pixel's corners to the left, or its neighbour's, to its right.
struct CornerPair {
  vec2 above;
  vec2 below;
};

CornerPair corner_pair(uvec2 pixel) {
  uint row = kThingBlock * tile_row() + 1u;
  uvec2 at = pixel + before_tile();
  uint first = at.y * row + at.x;
  return CornerPair(corners.values[first], corners.values[first + row]);
}

PixelCorners between_pairs(CornerPair a, CornerPair b) {
  vec2 least = min(min(a.above, a.below), min(b.above, b.below));
  vec2 most = max(max(a.above, a.below), max(b.above, b.below));
  return PixelCorners(least.x, most.x, least.y, most.y);
}

PixelCorners corners_of(uvec2 pixel) { return between_pairs(corner_pair(pixel), corner_pair(pixel + uvec2(1u, 0u))); }

// Whether the corners see terrain at distances too different to lie on one slope, or ground and terrain with different
// shares of the sun past bodies.
bool holds_step(PixelCorners of) { return of.farthest > 1.15 * of.nearest || of.most - of.least > 0.1; }

// Distance along the ground before which no ray of the pixel meets terrain.
float bare_before(PixelCorners of, vec3 direction, bool edge) {
  float before = edge ? 0.1 * of.nearest : of.farthest - of.nearest + terrain_shape().texel;
  return ground_distance(scene.planet, scene.camera.altitude, direction.y, max(of.nearest - before, 0.0));
}

// How a pixel is looked at.
struct PixelHolds {
  bool edge;     // rays stand on a grid
  bool mirror;   // they stand by mirror_place()
  uint count;    // of rays
  float spread;  // angle between neighbouring ones
  vec3 level;    // of its middle above the horizon, and the level's slopes per pixel, where rays stand by the horizon
};

// How wide a pixel is, and how it lies to the horizon.
struct PixelSides {
  vec2 width;  // angles across and from corner to corner
  vec3 level;
};

// Slopes of the level are known near the horizon alone, widths wherever a body may stand; `spread`: everywhere.
PixelSides sides_of(uvec2 pixel, vec3 middle, bool spread) {
  const float kInside = 0.49;  // of the pixel, so as not to cross the cut of a map
  PixelSides sides = PixelSides(vec2(0.0), vec3(0.0));
  sides.level.x = above_horizon(scene.planet, scene.camera.altitude, middle);
  vec3 before = vec3(0.0);
  float level_before = 0.0;
  bool near = kEdges != kEdgesLeftOut && is_near_level(scene.planet, scene.camera, kProjection, sides.level.x);
  if (!near && bodies_before() == 0u && !spread) {
    return sides;
  }
  // Across the pixel, from corner to corner, and down.
  DONT_UNROLL for (uint i = 0u; i < 6u; i++) {
    vec2 side = i < 2u ? vec2(1.0, 0.0) : i < 4u ? vec2(1.0) : vec2(0.0, 1.0);
    vec3 direction = direction_at(pixel, 0.5 + ((i & 1u) == 0u ? -kInside : kInside) * side);
    float level = above_horizon(scene.planet, scene.camera.altitude, direction);
    vec3 of = vec3(i == 1u, i == 3u, i == 5u);
    sides.width += of.xy * length(direction - before);
    sides.level.yz += of.xz * ((level - level_before) / (2.0 * kInside));
    before = direction;
    level_before = level;
  }
  sides.width /= 2.0 * kInside;
  return sides;
}

PixelRays horizon_rays(PixelSides sides) {
  return rays_at_level(scene.planet, scene.camera, kProjection, sides.level);
}

PixelHolds holds_alike(PixelSides sides) { return PixelHolds(false, false, 1u, sides.width.x, sides.level); }

PixelHolds holding_edge(PixelHolds holds) {
  holds.edge = true;
  holds.count = kEdgeSide * kEdgeSide;
  holds.spread /= float(kEdgeSide);
  return holds;
}

PixelHolds holding_mirror(PixelHolds holds) {
  holds.mirror = true;
  holds.count = kMirrorRays;
  holds.spread /= sqrt(float(kMirrorRays));
  return holds;
}

PixelHolds pixel_holds(uvec2 pixel, ViewRay view, PixelSides sides) {
  PixelHolds holds = holds_alike(sides);
  if (kProjection == kProjectionListed || kTiles == kTilesOfSky) {
    return PixelHolds(false, false, 1u, 0.0, vec3(0.0));
  }
  BodiesHeld bodies = bodies_held(view.direction, 2.0 * 0.49 * max(sides.width.x, sides.width.y));
  if (view.inside && (bodies.edge || holds_step(corners_of(pixel)))) {
    return holding_edge(holds);
  }
  if (view.inside && bodies.mirror) {
    return holding_mirror(holds);
  }
  holds.count = kEdges != kEdgesLeftOut ? horizon_rays(sides).count : 1u;
  return holds;
}

// One of a pixel's rays.
struct ThingRay {
  vec3 direction;
  float share;   // of the pixel
  float spread;  // angle to the next
  float bare;    // no terrain before that distance along the ground, km
};

ViewRay ray_at(uvec2 pixel, vec2 place);  // by the includer; `place` from the pixel's upper left corner

ThingRay thing_ray(uvec2 pixel, PixelHolds holds, uint i) {
  ThingRay ray = ThingRay(vec3(0.0), 1.0 / float(holds.count), holds.spread, 0.0);
  vec2 on_grid = (vec2(float(i % kEdgeSide), float(i / kEdgeSide)) + 0.5) / float(kEdgeSide);
  vec2 place = holds.edge ? on_grid : holds.mirror ? mirror_place(i) : vec2(0.5);
  bool of_horizon = holds.count > 1u && !holds.edge && !holds.mirror;
  PixelRay part = PixelRay(0.0, 0.0, 1.0, false);
  if (kEdges != kEdgesLeftOut && of_horizon) {
    part = ray_of_pixel(rays_at_level(scene.planet, scene.camera, kProjection, holds.level), i);
    place += vec2(part.x, part.y);
    ray.share = part.share;
  }
  vec3 direction = ray_at(pixel, place).direction;
  vec3 held = held_to_side(scene.planet, scene.camera.altitude, direction, part.ground);
  ray.direction = of_horizon ? held : direction;
  if (kProjection != kProjectionListed && kTiles != kTilesOfSky && has_terrain()) {
    ray.bare = bare_before(corners_of(pixel), ray.direction, holds.edge || holds.mirror);
  }
  return ray;
}
