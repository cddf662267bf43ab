// The list of a picture's blocks of pixels (passes/thing_tiles.comp). For each of two kinds it holds three counts of
// workgroups, one for a block, and the number of blocks. Then come the blocks as x and y of 16 bits, those of the sky
// alone from the front, those of things from the back.

const uint kTileGroups = 64u;  // workgroups along x: a device need not take more than 65535 along an axis

uint tile_count_place(uint kind) { return kind == kTilesOfSky ? 3u : 7u; }
uint tile_group_place(uint kind) { return kind == kTilesOfSky ? 0u : 4u; }

uint tile_place(uint kind, uint i, uvec2 picture) {
  uvec2 blocks = (picture + kThingBlock - 1u) / kThingBlock;
  return kTileWords + (kind == kTilesOfSky ? i : blocks.x * blocks.y - 1u - i);
}
