#version 460
#extension GL_GOOGLE_include_directive : require
// What the blocks of a picture's pixels show: one block a workgroup. Pixels count that a tile does not hold, so that
// each tile finds the same of a block.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_pixel.glsl"
#include "shared/thing_light.h"
#include "shared/thing_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 43) writeonly buffer Blocks { ThingBlock values[]; } blocks_out;

shared uint near;  // bits of distances, which are ordered as these are
shared uint far;
shared uint shadowed;
shared uint shows;

struct Shown {
  float near;  // of surfaces; farther than any: there is none
  float far;
  float shadowed;
  uint shows;
};

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

Shown shown_by(uvec2 pixel) {
  ViewRay view = picture_ray(pixel);
  Sight sight = sight_of(vec3(0.0), view.direction);
  PixelCorners seen = corners_of(pixel);
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  bool terrain = seen.farthest < kNoTerrain;  // at all corners
  Shown of = Shown(1e30, 0.0, 0.0, ground || rays_at(pixel, view).count > 1u ? kAtGround : 0u);
  if (seen.nearest < kNoTerrain) {
    of = with_surface(of, seen.nearest, terrain ? seen.farthest : seen.nearest);
  }
  if (ground && !terrain) {
    float far_ = sight.before + sight.ray.length_;
    of = with_surface(of, far_, far_);
  }
  bool body = nearest_body(vec3(0.0), view.direction, kNoBody).hit;
  of.shows |= ground || terrain || body ? 0u : kShowsSky;
  return with_bodies(of, pixel, view.direction);
}

void main() {
  uvec2 pixel = first_of_block(gl_WorkGroupID.xy) + gl_LocalInvocationID.xy;
  if (gl_LocalInvocationIndex == 0u) {
    near = floatBitsToUint(1e30);
    far = 0u;
    shadowed = 0u;
    shows = 0u;
  }
  barrier();
  if (is_in_picture(pixel)) {
    Shown of = shown_by(pixel);
    atomicMin(near, floatBitsToUint(of.near));
    atomicMax(far, floatBitsToUint(of.far));
    atomicMax(shadowed, floatBitsToUint(of.shadowed));
    atomicOr(shows, of.shows);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    ThingBlock block;
    block.near = uintBitsToFloat(near);
    block.far = uintBitsToFloat(far);
    block.shadowed = uintBitsToFloat(shadowed);
    block.shows = shows;
    blocks_out.values[gl_WorkGroupID.y * tile_row() + gl_WorkGroupID.x] = block;
  }
}
