// The list of a tile's blocks of pixels by the pass that renders them (thing_listing.glsl). For each kind it holds
// three counts of workgroups and the number of blocks. Then come the blocks as x and y of 16 bits: of two kinds from
// the front and from the back of a row as long as there are blocks, of the third in a second one.

// Blocks of a workgroup: of the sky all pixels of one, of others one in four of their pixels (thing_quads.glsl).
const uint kTileBlocks = 4u;
uint blocks_of_group(uint kind) { return kind == kTilesOfSky ? 1u : kTileBlocks; }

const uint kTileGroups = 64u;  // workgroups along x: a device need not take more than 65535 along an axis

uint tile_group_place(uint kind) { return 4u * (kind - 1u); }
uint tile_count_place(uint kind) { return tile_group_place(kind) + 3u; }

// `all`: number of blocks.
uint tile_place(uint kind, uint i, uint all) {
  return kTileWords + (kind == kTilesOfSky ? i : kind == kTilesOfThings ? all - 1u - i : all + i);
}
