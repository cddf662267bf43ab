// The pixels of a pass over things. Those of several rays are listed block by block and rendered by themselves: beside
// the others every lane would wait for the rays of an edge.
// The includer defines:
//   uint width, height;
//   ViewRay ray_of_pixel(uvec2 pixel);
//   void render(ViewRay view, ThingPixel rays);  the pixel `here`

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef AIRLIGHT_TILES
#include "shared/thing_tiles.glsl"
// passes/thing_tiles.comp; any buffer where kTiles is kTilesAll
layout(scalar, set = 0, binding = 33) readonly buffer Tiles { uint values[]; } tiles;
#endif

// A block of pixels is one of threads, so that no thread has more than one of the list to render: a software device ends
// the loops of a shader after 65536 turns.
shared uint listed;
shared uint list[kThingBlock * kThingBlock];

bool in_picture(uvec2 pixel) { return pixel.x < width && pixel.y < height; }

// The first pixel of the group's block; outside of the picture where there is none.
uvec2 first_pixel() {
#ifdef AIRLIGHT_TILES
  if (kTiles != kTilesAll) {
    uint i = gl_WorkGroupID.y * kTileGroups + gl_WorkGroupID.x;
    if (i >= tiles.values[tile_count_place(kTiles)]) {
      return uvec2(width, height);
    }
    uint block = tiles.values[tile_place(kTiles, i, uvec2(width, height))];
    return kThingBlock * uvec2(block & 0xffffu, block >> 16u);
  }
#endif
  return kThingBlock * gl_WorkGroupID.xy;
}

// Two turns of one loop, so that the code of a pixel stands once: pipelines are made in half the time.
void main() {
  uint lane = gl_LocalInvocationIndex;
  uvec2 first = first_pixel();
  here = first + gl_LocalInvocationID.xy;
  if (lane == 0u) {
    listed = 0u;
  }
  barrier();
  bool mine = in_picture(here);
  for (uint turn = 0u; turn < 2u; turn++) {
    if (mine) {
      ViewRay view = ray_of_pixel(here);
      ThingPixel rays = thing_pixel(here, view);
      if (turn == 0u && rays.count > 1u) {
        list[atomicAdd(listed, 1u)] = lane;
      } else {
        render(view, rays);
      }
    }
    barrier();
    if (listed == 0u) {
      break;
    }
    mine = lane < listed;
    uint k = list[min(lane, listed - 1u)];
    here = first + uvec2(k % kThingBlock, k / kThingBlock);
  }
}
