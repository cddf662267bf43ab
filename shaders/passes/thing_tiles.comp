#version 460
#extension GL_GOOGLE_include_directive : require
// Which blocks of a picture's pixels show the sky alone: one block a workgroup.
#include "shared/device.glsl"
#include "shared/things.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_pixel.glsl"
#include "shared/thing_light.h"
#include "shared/thing_tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 33) buffer Tiles { uint values[]; } tiles_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

shared uint things;  // pixels that show more than the sky

// Whether the pixel's ray alone, and no light of a surface, is the pixel.
bool shows_sky_alone(uvec2 pixel) {
  ViewRay view = picture_ray(pixel);
  ThingPixel rays = thing_pixel_of(pixel, view, false);  // no mirror is sky
  Sight sight = sight_of(vec3(0.0), view.direction);
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  bool body = nearest_body(vec3(0.0), view.direction, kNoBody).hit;
  return rays.count == 1u && !ground && !body && corners_of(pixel).nearest >= kNoTerrain;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (gl_LocalInvocationIndex == 0u) {
    things = 0u;
  }
  barrier();
  if (pixel.x < width && pixel.y < height && !shows_sky_alone(pixel)) {
    atomicAdd(things, 1u);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    uint kind = things == 0u ? kTilesOfSky : kTilesOfThings;
    uint i = atomicAdd(tiles_out.values[tile_count_place(kind)], 1u);
    uint groups = tile_group_place(kind);
    tiles_out.values[groups] = kTileGroups;
    atomicMax(tiles_out.values[groups + 1u], i / kTileGroups + 1u);
    tiles_out.values[groups + 2u] = 1u;
    tiles_out.values[tile_place(kind, i, uvec2(width, height))] = gl_WorkGroupID.x | (gl_WorkGroupID.y << 16u);
  }
}
