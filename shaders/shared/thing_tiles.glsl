// The list of a tile's blocks of pixels by the pass that renders them (thing_listing.glsl). For each kind it
// holds three counts of workgroups, one for a block, and the number of blocks. Then come the blocks as x and y of 16
// bits: of two kinds from the front and from the back of a row as long as there are blocks, of the third in a second
// one.

const uint kTileGroups = 64u;  // workgroups along x: a device need not take more than 65535 along an axis

uint tile_group_place(uint kind) { return 4u * (kind - 1u); }
uint tile_count_place(uint kind) { return tile_group_place(kind) + 3u; }

// `all`: number of blocks.
uint tile_place(uint kind, uint i, uint all) {
  return kTileWords + (kind == kTilesOfSky ? i : kind == kTilesOfThings ? all - 1u - i : all + i);
}
