#version 460
#extension GL_GOOGLE_include_directive : require
// What the corners of pixels see, by which pixels tell edges and begin their search for terrain: the distance of
// terrain, and the share of the sun that bodies leave to ground or terrain there.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 9) writeonly buffer Corners { vec2 values[]; } corners_out;
layout(push_constant, scalar) uniform Push {
  uint width;  // of the tile's blocks and 1
  uint height;
};

// A thread has a quad of 2 x 2 corners, and of its block of kThingBlock x kThingBlock 16 threads: one corner is looked
// at, and three lie between it and those of the threads beside it (quad_ray()). They are looked at where these differ.
const uint kThreadsAcross = 8u;
const uint kQuadsAcross = kThingBlock / 2u;
shared vec2 seen[kThreadsAcross * kThreadsAcross];
shared vec3 points[kThreadsAcross * kThreadsAcross];

struct CornerSeen {
  vec2 value;
  vec3 point;  // of ground or terrain; 0: neither is seen
};

CornerSeen seen_at(uvec2 corner) {
  vec2 at = vec2(corner + uvec2(scene.tile.x, scene.tile.y) - before_tile());
  vec3 direction = view_ray(scene.camera, kProjection, at.x, at.y).direction;
  Sight sight = sight_of(vec3(0.0), direction);
  float terrain = kNoTerrain;
  if (has_terrain()) {
    TerrainHit hit = terrain_hit(scene.planet, sight.track);
    terrain = hit.hit ? hit.distance_ : kNoTerrain;
  }
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  bool shows = terrain < kNoTerrain || ground;
  vec3 point = direction * (terrain < kNoTerrain ? terrain : sight.before + sight.ray.length_);
  float share = sun_past_bodies(point, scene.sun.seen, scene.sun.angular_radius, kNoBody);
  // A body hides edges of shadows behind it, and has one where it stands in the ground.
  BodyHit body = nearest_body(vec3(0.0), direction, kNoBody);
  bool hidden = body.hit && !(shows && body.distance_ > length(point));
  bool lit = shows && !hidden;
  return CornerSeen(vec2(terrain, hidden ? kBodySeen : lit ? share : 1.0), lit ? point : vec3(0.0));
}

const float kFartherAlike = 1.02;  // distances of terrain

void main() {
  uvec2 thread = gl_LocalInvocationID.xy;
  uvec2 quad = thread % kQuadsAcross;
  uvec2 block = kThingBlock * (2u * gl_WorkGroupID.xy + thread / kQuadsAcross);
  const uvec2 kLast = uvec2(kThingBlock - 1u);  // those beyond the picture as well, so that tiles have the same
  uvec2 own = quad_ray(quad, kQuadsAcross, kLast);
  uvec2 other = 4u * quad + 1u - own;
  uvec2 toward = uvec2(quad.x < kQuadsAcross / 2u ? 1u : -1u, quad.y < kQuadsAcross / 2u ? 1u : -1u);  // they wrap
  vec2 along = 1.0 / abs(vec2(quad_ray(quad + toward, kQuadsAcross, kLast)) - vec2(own));
  uint lane = gl_LocalInvocationIndex;
  uint beside = lane + toward.x;
  uint below = kThreadsAcross * toward.y;
  bool alike = false;
  for (uint round = 0u; round < 2u; round++) {
    uint end = round == 0u ? 1u : alike ? 0u : 4u;
    for (uint k = round; k < end; k++) {
      uvec2 corner = block + uvec2((k & 1u) == 0u ? own.x : other.x, k < 2u ? own.y : other.y);
      CornerSeen found = seen_at(corner);
      if (k == 0u) {
        seen[lane] = found.value;
        points[lane] = found.point;
      }
      if (corner.x < width && corner.y < height) {
        corners_out.values[corner.y * width + corner.x] = found.value;
      }
    }
    barrier();
    vec2 a = seen[lane];
    vec2 b = seen[beside];
    vec2 c = seen[lane + below];
    vec2 d = seen[beside + below];
    vec2 least = min(min(a, b), min(c, d));
    vec2 most = max(max(a, b), max(c, d));
    vec3 point = points[lane];
    float wide = max(max(length(points[beside] - point), length(points[lane + below] - point)),
                     length(points[beside + below] - point));
    // Between places that are lit alike there may be a small body's shadow.
    alike = most.x <= kFartherAlike * least.x && most.y == least.y && is_evenly_lit(point, wide);
    for (uint k = 1u; k < (round == 0u && alike ? 4u : 0u); k++) {
      uvec2 corner = block + uvec2((k & 1u) == 0u ? own.x : other.x, k < 2u ? own.y : other.y);
      vec2 share = vec2((k & 1u) == 0u ? 0.0 : along.x, k < 2u ? 0.0 : along.y);
      float between = mix(mix(a.x, b.x, share.x), mix(c.x, d.x, share.x), share.y);
      if (corner.x < width && corner.y < height) {
        corners_out.values[corner.y * width + corner.x] = vec2(least.x < kNoTerrain ? between : kNoTerrain, a.y);
      }
    }
  }
}
