// The rays whose mean is a pixel of a picture of things.
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"


layout(scalar, set = 0, binding = 18) readonly buffer Corners { vec2 values[]; } corners;  // of the tile's blocks, row by row

const uint kEdgeSide = 4u;  // rays across a pixel with an edge or a shadow's sharp edge
// Rays of a pixel wholly in a mirror or on a shadow's wide edge. No two share a row or a column of 8, so that an edge
// along either is resolved in eight steps; as graphics hardware places its eight samples.
const uint kSeveralRays = 8u;
vec2 several_place(uint i) {
  uvec2 at = (uvec2(0x75012634u, 0x07361452u) >> (4u * i)) & 7u;
  return (vec2(at) + 0.5) / float(kSeveralRays);
}

ViewRay camera_ray(uvec2 pixel, vec2 place) {
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y);
}

vec3 direction_at(uvec2 pixel, vec2 place) { return camera_ray(pixel, place).direction; }

// What a pixel, which extends by `reach` from its middle, holds of bodies.
struct BodiesHeld {
  uint limb;    // the body whose edge is a line across the pixel, with even light on either side; or kNoBody
  bool edge;    // another
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

// Whether light is even within a body's edge near a direction: it is not in a mirror, on a small ball, or where the
// edge of the body's own shadow comes near.
bool has_limb(uint i, vec3 direction, float reach) {
  const float kLeast = 15.0;  // radius in pixels' diagonals
  SphereData ball = ball_of_body(i);
  float far = length(ball.centre);
  vec3 to = ball.centre / far;
  vec3 out_ = normalize(direction - to * dot(direction, to));
  float turn = sqrt(2.0 * reach * far / ball.radius);  // of the normal within a pixel
  bool lit = abs(dot(out_, scene.sun.seen)) > 1.5 * turn * abs(dot(to, scene.sun.seen));
  return ball.material != kSphereMirror && ball.radius > kLeast * reach * far && lit;
}

// The body whose limb crosses a pixel that has one.
uint limb_near(vec3 direction, float reach) {
  uint which = kNoBody;
  for (uint i = 0u; i < bodies_before(); i++) {
    which = has_limb(i, direction, reach) && abs(angle_from_body(i, direction)) < 0.6 * reach ? i : which;
  }
  return which;
}

BodiesHeld bodies_held(vec3 direction, float reach) {
  BodiesHeld held = BodiesHeld(kNoBody, false, false);
  uint near = 0u;
  uint which = 0u;
  float off_edge = 0.0;
  for (uint i = 0u; i < bodies_before(); i++) {
    float off = angle_from_body(i, direction);
    // Beside a body a pixel is even, within its edge it may not be.
    bool is_near = off < 0.6 * reach && off > -reach;
    near += is_near ? 1u : 0u;
    which = is_near ? i : which;
    off_edge = is_near ? off : off_edge;
    held.mirror = held.mirror || (ball_of_body(i).material == kSphereMirror && off < 0.0);
  }
  held.edge = near > 0u;
  // A loop in place of a condition: pixels away from bodies do not wait for it on a software device.
  uint turns = near == 1u && !held.mirror ? 1u : 0u;
  for (uint turn = 0u; turn < turns; turn++) {
    bool even = has_limb(which, direction, reach);
    held.edge = !even;
    held.limb = even && off_edge > -0.6 * reach ? which : kNoBody;
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
  float most_open;  // of corners that see no body
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
  vec4 shares = vec4(a.above.y, a.below.y, b.above.y, b.below.y);
  vec4 open = mix(shares, vec4(0.0), greaterThan(shares, vec4(1.0)));
  return PixelCorners(least.x, most.x, least.y, most.y, max(max(open.x, open.y), max(open.z, open.w)));
}

PixelCorners corners_of(uvec2 pixel) { return between_pairs(corner_pair(pixel), corner_pair(pixel + uvec2(1u, 0u))); }

// Whether the corners see terrain at distances too different to lie on one slope.
bool holds_skyline(PixelCorners of) { return of.farthest > 1.15 * of.nearest; }

// How far the shares of the sun past bodies differ that ground and terrain get at the corners. `limb`: some of them may
// see a body instead.
float step_of_shares(PixelCorners of, bool limb) { return (limb ? of.most_open : of.most) - of.least; }

const float kLeastStep = 0.1;
const float kWholeStep = 0.6;  // below, the shadow's edge is wider than the pixel

// Distance along the ground before which no ray of the pixel meets terrain.
float bare_before(PixelCorners of, vec3 direction, bool edge) {
  float before = edge ? 0.1 * of.nearest : of.farthest - of.nearest + terrain_shape().texel;
  return ground_distance(scene.planet, scene.camera.altitude, direction.y, max(of.nearest - before, 0.0));
}

// How a pixel is looked at.
struct PixelHolds {
  bool edge;     // rays stand on a grid
  bool several;  // they stand by several_place()
  bool limb;     // they stand by a body's edge
  uint count;    // of rays
  float spread;  // angle between neighbouring ones
  vec3 level;    // of its middle above the horizon or the body's edge, and its slopes per pixel
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

float pixel_width(PixelSides sides) { return 2.0 * 0.49 * max(sides.width.x, sides.width.y); }

PixelRays horizon_rays(PixelSides sides) {
  return rays_at_level(scene.planet, scene.camera, kProjection, sides.level);
}

PixelHolds holds_alike(PixelSides sides) {
  return PixelHolds(false, false, false, 1u, sides.width.x, sides.level);
}

PixelHolds holding_edge(PixelHolds holds) {
  holds.edge = true;
  holds.count = kEdgeSide * kEdgeSide;
  holds.spread /= float(kEdgeSide);
  return holds;
}

PixelHolds holding_several(PixelHolds holds) {
  holds.several = true;
  holds.count = kSeveralRays;
  holds.spread /= sqrt(float(kSeveralRays));
  return holds;
}

// Across a limb light changes by a step, so either side is one ray in its middle, as at the horizon.
PixelHolds holding_limb(PixelHolds holds, uvec2 pixel, vec3 middle, uint body) {
  const float kInside = 0.49;  // of the pixel
  float sides[4];
  DONT_UNROLL for (uint i = 0u; i < 4u; i++) {
    vec2 side = i < 2u ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    sides[i] = angle_from_body(body, direction_at(pixel, 0.5 + ((i & 1u) == 0u ? -kInside : kInside) * side));
  }
  holds.level = vec3(angle_from_body(body, middle), sides[1] - sides[0], sides[3] - sides[2]);
  holds.level.yz /= 2.0 * kInside;
  holds.count = rays_of_pixel(holds.level.x, holds.level.y, holds.level.z, 0.0).count;
  holds.limb = holds.count > 1u;
  return holds;
}

PixelHolds pixel_holds(uvec2 pixel, ViewRay view, PixelSides sides) {
  PixelHolds holds = holds_alike(sides);
  if (kProjection == kProjectionListed || kTiles == kTilesOfSky) {
    return PixelHolds(false, false, false, 1u, 0.0, vec3(0.0));
  }
  BodiesHeld bodies = bodies_held(view.direction, pixel_width(sides));
  bool limb = bodies.limb != kNoBody;
  holds.count = kEdges != kEdgesLeftOut ? horizon_rays(sides).count : 1u;
  PixelCorners seen = corners_of(pixel);
  float step = step_of_shares(seen, limb);
  bool edge = bodies.edge || (limb && holds.count > 1u) || holds_skyline(seen) || step > kWholeStep;
  if (view.inside && edge) {
    return holding_edge(holds);
  }
  if (view.inside && (bodies.mirror || step > kLeastStep)) {
    return holding_several(holds);
  }
  uint turns = view.inside && limb ? 1u : 0u;
  for (uint turn = 0u; turn < turns; turn++) {
    holds = holding_limb(holds, pixel, view.direction, bodies.limb);
  }
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
  vec2 place = holds.edge ? on_grid : holds.several ? several_place(i) : vec2(0.5);
  bool by_level = holds.count > 1u && !holds.edge && !holds.several;
  PixelRay part = PixelRay(0.0, 0.0, 1.0, false);
  if (kEdges != kEdgesLeftOut && by_level) {
    PixelRays rays = rays_of_pixel(holds.level.x, holds.level.y, holds.level.z, 0.0);
    if (!holds.limb) {
      rays = rays_at_level(scene.planet, scene.camera, kProjection, holds.level);
    }
    part = ray_of_pixel(rays, i);
    place += vec2(part.x, part.y);
    ray.share = part.share;
  }
  vec3 direction = ray_at(pixel, place).direction;
  vec3 held = held_to_side(scene.planet, scene.camera.altitude, direction, part.ground);
  ray.direction = by_level && !holds.limb ? held : direction;
  if (kProjection != kProjectionListed && kTiles != kTilesOfSky && has_terrain()) {
    ray.bare = bare_before(corners_of(pixel), ray.direction, holds.edge || holds.several);
  }
  return ray;
}
