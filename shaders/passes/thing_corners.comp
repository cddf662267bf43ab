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
// at, and three lie between it and those of the threads beside it (quad_ray()). Where these differ, they are looked at
// too: those of all threads stand in a list, so that no thread has three rays while others have none.
const uint kThreadsAcross = 8u;
const uint kThreads = kThreadsAcross * kThreadsAcross;
const uint kQuadsAcross = kThingBlock / 2u;
const uvec2 kLast = uvec2(kThingBlock - 1u);  // places beyond the picture count as well, so that tiles have the same
shared vec2 seen[kThreads];
shared vec3 points[kThreads];
shared uint more[3u * kThreads];  // corners to be looked at: 4 times the thread's place, and which of its corners
shared uint more_count;

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

// The corners of a thread.
struct CornerQuad {
  uvec2 block;   // the first corner of its block
  uvec2 quad;    // place in the block
  uvec2 own;     // the corner that is looked at, in the block
  uvec2 toward;  // to the thread beside and below it, between whose corners the others lie; -1 wraps
};

CornerQuad corner_quad(uint place) {
  uvec2 thread = uvec2(place % kThreadsAcross, place / kThreadsAcross);
  CornerQuad q;
  q.block = kThingBlock * (2u * gl_WorkGroupID.xy + thread / kQuadsAcross);
  q.quad = thread % kQuadsAcross;
  q.own = quad_ray(q.quad, kQuadsAcross, kLast);
  q.toward = uvec2(q.quad.x < kQuadsAcross / 2u ? 1u : -1u, q.quad.y < kQuadsAcross / 2u ? 1u : -1u);
  return q;
}

// Corner k; 0: that which is looked at.
uvec2 corner_of(CornerQuad q, uint k) {
  uvec2 other = 4u * q.quad + 1u - q.own;
  return q.block + uvec2((k & 1u) == 0u ? q.own.x : other.x, k < 2u ? q.own.y : other.y);
}

void write_corner(uvec2 corner, vec2 value) {
  if (corner.x < width && corner.y < height) {
    corners_out.values[corner.y * width + corner.x] = value;
  }
}

// Writes the other corners of a thread where those around them see alike; elsewhere they are listed.
void find_others(uint lane, CornerQuad q) {
  uint beside = lane + q.toward.x;
  uint below = kThreadsAcross * q.toward.y;
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
  bool alike = most.x <= kFartherAlike * least.x && most.y == least.y && is_evenly_lit(point, wide);
  vec2 along = 1.0 / abs(vec2(quad_ray(q.quad + q.toward, kQuadsAcross, kLast)) - vec2(q.own));
  if (alike) {
    for (uint k = 1u; k < 4u; k++) {
      vec2 share = vec2((k & 1u) == 0u ? 0.0 : along.x, k < 2u ? 0.0 : along.y);
      float between = mix(mix(a.x, b.x, share.x), mix(c.x, d.x, share.x), share.y);
      write_corner(corner_of(q, k), vec2(least.x < kNoTerrain ? between : kNoTerrain, a.y));
    }
  } else {
    uint first = atomicAdd(more_count, 3u);
    for (uint k = 1u; k < 4u; k++) {
      more[first + k - 1u] = 4u * lane + k;
    }
  }
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  if (lane == 0u) {
    more_count = 0u;
  }
  for (uint round = 0u; round < 2u; round++) {
    uint count = round == 0u ? kThreads : more_count;
    for (uint i = lane; i < count; i += kThreads) {
      uint asked = round == 0u ? 4u * i : more[i];
      uvec2 corner = corner_of(corner_quad(asked / 4u), asked % 4u);
      CornerSeen found = seen_at(corner);
      if (round == 0u) {
        seen[lane] = found.value;
        points[lane] = found.point;
      }
      write_corner(corner, found.value);
    }
    barrier();
    if (round == 0u) {
      find_others(lane, corner_quad(lane));
    }
    barrier();
  }
}
