// The pixels of a block between rays. Of each 2 x 2 pixels, a quad, one stands on a ray; across the block these are at
// 0, 2, 5 and 7. So all others lie between rays: those of a quad between its own and three beside it, and no two blocks
// need one another.

const uint kQuadsAcross = 4u;  // a block
const uint kQuads = kQuadsAcross * kQuadsAcross;
const uint kQuadPixels = 4u;
const uint kThreads = 64u;

uvec2 quad_place(uint quad) { return uvec2(quad % kQuadsAcross, quad / kQuadsAcross); }

// Pixel `which` of a quad, 0 on the ray, 1 beside it, 2 below or above it, 3 the fourth. `last`: of the block in the
// picture.
uvec2 place_in_block(uint quad, uint which, uvec2 last) {
  uvec2 at = quad_place(quad);
  uvec2 on_ray = quad_ray(at, kQuadsAcross, last);
  uvec2 other = 4u * at + 1u - on_ray;
  return uvec2((which & 1u) == 0u ? on_ray.x : other.x, which < 2u ? on_ray.y : other.y);
}

// What a ray on a quad sees.
struct QuadSeen {
  vec3 light;
  uint met;
#ifdef AIRLIGHT_CLOUDS
  float distance_;  // of the thing that it meets, km; 0: none
#endif
};
#ifdef AIRLIGHT_CLOUDS
float distance_of(QuadSeen quad) { return quad.distance_; }
#else
float distance_of(QuadSeen quad) { return 0.0; }
#endif

#include "shared/thing_tiles.glsl"
layout(scalar, set = 0, binding = 33) readonly buffer Tiles { uint values[]; } tiles;  // thing_listing.glsl

uvec2 block_rows() { return uvec2(tile_row(), whole_blocks(before_tile().y + height)); }

// A block of the list; `there`: false past its end.
struct ListedBlock {
  uvec2 at;
  bool there;
};

ListedBlock listed_block(uint which) {
  uint i = (gl_WorkGroupID.y * kTileGroups + gl_WorkGroupID.x) * blocks_of_group(kTiles) + which;
  uint count = tiles.values[tile_count_place(kTiles)];
  uint block = tiles.values[tile_place(kTiles, min(i, max(count, 1u) - 1u), block_rows().x * block_rows().y)];
  return ListedBlock(uvec2(block & 0xffffu, block >> 16u), i < count);
}

uint block_number(uvec2 block) { return block.y * tile_row() + block.x; }
