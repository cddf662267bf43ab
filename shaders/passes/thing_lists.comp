#version 460
#extension GL_GOOGLE_include_directive : require
// The list of a picture's blocks of pixels where no terrain stands: those of the sky, and those of the ground, from all
// rays of which bodies and their shadows stand aside, and all others.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/thing_light.h"
#include "shared/thing_tile.glsl"
#include "shared/thing_listing.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint all; };  // blocks

vec3 direction_in(uvec2 pixel, vec2 place) {
  vec2 at = vec2(ivec2(pixel) + ivec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y).direction;
}

void main() {
  uint index = min(gl_GlobalInvocationID.x, all - 1u);
  uvec2 block = uvec2(index % tile_row(), index / tile_row());
  uvec2 first = first_of_block(block);
  const float kSide = float(kThingBlock);
  vec3 direction = direction_in(first, vec2(0.5 * kSide));
  float wide = 0.0;
  UNROLL for (uint i = 0u; i < 4u; i++) {
    vec2 corner = vec2(i & 1u, i >> 1u);
    // A pixel asks as far as its neighbours whether it shows an edge.
    vec3 there = direction_in(first, mix(vec2(-1.5), vec2(kSide + 1.5), corner));
    wide = max(wide, 1.05 * length(there - direction));
  }
  bool aside = true;
  for (uint i = 0u; i < body_count(); i++) {
    aside = aside && stands_aside(scene.planet, scene.camera.altitude, i, direction, wide, scene.sun);
  }
  bool sky = direction.y - wide > scene.camera.edge_high;
  uint kind = !aside ? kTilesExact : sky ? kTilesOfSky : kTilesOfThings;
  list_block(gl_GlobalInvocationID.x < all, kind, block, all);
}
