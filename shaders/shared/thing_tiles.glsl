// The list of a picture's blocks of pixels (passes/thing_tiles.comp): for each of two kinds three counts of workgroups, of
// which one takes a block, and the number of blocks; then the blocks as x and y of 16 bits, those of the sky alone from
// the front, those of things from the back.

const uint kTileGroups = 64u;  // workgroups along x: no device takes more than 65535 along each axis for granted

uint tile_count_place(uint kind) { return kind == kTilesOfSky ? 3u : 7u; }
uint tile_group_place(uint kind) { return kind == kTilesOfSky ? 0u : 4u; }

uint tile_place(uint kind, uint i, uvec2 picture) {
  uvec2 blocks = (picture + kThingBlock - 1u) / kThingBlock;
  return kTileWords + (kind == kTilesOfSky ? i : blocks.x * blocks.y - 1u - i);
}
