// Blocks of pixels are put in the list of thing_tiles.glsl.
#include "shared/thing_tiles.glsl"

layout(scalar, set = 0, binding = 33) buffer Tiles { uint values[]; } tiles_out;

const uint kKinds = 3u;
shared uint counts[kKinds];  // blocks of the workgroup by kind
shared uint firsts[kKinds];  // where they begin in the list

// All threads of a workgroup call it at once, those with a block to list with `lists`. `all`: number of blocks.
void list_block(bool lists, uint kind, uvec2 block, uint all) {
  uint thread = gl_LocalInvocationIndex;
  if (thread < kKinds) {
    counts[thread] = 0u;
  }
  barrier();
  uint place = lists ? atomicAdd(counts[kind - 1u], 1u) : 0u;
  barrier();
  // Of all blocks one by one, the count would be the whole pass of a GPU.
  if (thread < kKinds && counts[thread] > 0u) {
    uint count = counts[thread];
    uint first = atomicAdd(tiles_out.values[tile_count_place(thread + 1u)], count);
    uint groups = tile_group_place(thread + 1u);
    tiles_out.values[groups] = kTileGroups;
    atomicMax(tiles_out.values[groups + 1u], (first + count - 1u) / (blocks_of_group(thread + 1u) * kTileGroups) + 1u);
    tiles_out.values[groups + 2u] = 1u;
    firsts[thread] = first;
  }
  barrier();
  if (lists) {
    tiles_out.values[tile_place(kind, firsts[kind - 1u] + place, all)] = block.x | (block.y << 16u);
  }
}
