#version 460
#extension GL_GOOGLE_include_directive : require
// What the blocks of a picture's pixels show: one thread a row of a block. Pixels count that a tile does not hold, so
// that each tile finds the same of a block.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_pixel.glsl"
#include "shared/thing_light.h"
#include "shared/thing_blocks.glsl"

const uint kThreads = 128u;
layout(local_size_x = 128) in;
layout(scalar, set = 0, binding = 43) writeonly buffer Blocks { ThingBlock values[]; } blocks_out;
layout(push_constant, scalar) uniform Push { uint all; };  // blocks

struct Shown {
  float near;  // of surfaces; farther than any: there is none
  float far;
  float shadowed;
  uint shows;
};

shared Shown rows[kThreads];

Shown both(Shown a, Shown b) {
  return Shown(min(a.near, b.near), max(a.far, b.far), max(a.shadowed, b.shadowed), a.shows | b.shows);
}

Shown with_surface(Shown of, float near_, float far_) {
  of.near = min(of.near, near_);
  of.far = max(of.far, far_);
  of.shows |= kShowsThings;
  return of;
}

// Bodies at the pixel or next to it, and how long the shadow of each is on the way to what it shows.
Shown with_bodies(Shown of, uvec2 pixel, vec3 direction) {
  float reach = 2.0 * length(direction_at(pixel, vec2(1.0)) - direction_at(pixel, vec2(0.0)));
  for (uint i = 0u; i < body_count(); i++) {
    SphereData ball = ball_of_body(i);
    float far_ = length(ball.centre);
    if (angle_from_body(i, direction) < reach) {
      of = with_surface(of, max(far_ - ball.radius, 0.0), far_);
      of.shows |= ball.material == kSphereMirror ? kHasExact : 0u;
    }
  }
  float up_to = of.far > 0.0 ? of.far : 1e30;
  for (uint i = 0u; i < body_count(); i++) {
    ShadowSpan span = shadow_of_body(i, vec3(0.0), direction, scene.sun.seen);
    of.shadowed += max(min(span.to, up_to) - max(span.from, 0.0), 0.0);
  }
  return of;
}

Shown shown_by(uvec2 pixel, PixelCorners seen) {
  ViewRay view = picture_ray(pixel);
  Sight sight = sight_of(vec3(0.0), view.direction);
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  bool terrain = seen.farthest < kNoTerrain;  // at all corners
  bool horizon = rays_at(pixel, view).count > 1u;
  Shown of = Shown(1e30, 0.0, 0.0, ground || horizon ? kAtGround : 0u);
  if (seen.nearest < kNoTerrain) {
    of = with_surface(of, seen.nearest, terrain ? seen.farthest : seen.nearest);
  }
  if (ground && !terrain) {
    float far_ = sight.before + sight.ray.length_;
    of = with_surface(of, far_, far_);
  }
  bool body = nearest_body(vec3(0.0), view.direction, kNoBody).hit;
  of.shows |= (ground && !horizon) || terrain || body ? 0u : kShowsSky;
  return with_bodies(of, pixel, view.direction);
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uint row = thread % kThingBlock;
  uint block = gl_GlobalInvocationID.x / kThingBlock;
  bool mine = block < all;
  block = min(block, all - 1u);
  uvec2 first = first_of_block(uvec2(block % tile_row(), block / tile_row())) + uvec2(0u, row);
  Shown of = Shown(1e30, 0.0, 0.0, 0u);
  CornerPair left = corner_pair(first);
  DONT_UNROLL for (uint k = 0u; k < kThingBlock; k++) {
    uvec2 pixel = first + uvec2(k, 0u);
    CornerPair right = corner_pair(pixel + uvec2(1u, 0u));
    if (mine && is_in_picture(pixel)) {
      of = both(of, shown_by(pixel, between_pairs(left, right)));
    }
    left = right;
  }
  rows[thread] = of;
  barrier();
  if (!mine || row > 0u) {
    return;
  }
  for (uint i = 1u; i < kThingBlock; i++) {
    of = both(of, rows[thread + i]);
  }
  blocks_out.values[block] = ThingBlock(of.near, of.far, of.shadowed, of.shows);
}
