// The blocks of pixels of a tile. They are those of the whole picture in every tile, so a tile may begin and end within
// a block; pixels of a block before the tile have numbers below 0, as unsigned numbers wrap.

layout(constant_id = 38) const uint kTiles = kTilesAll;

// Pixels between the first block's and the tile's first.
uvec2 before_tile() { return uvec2(scene.tile.x, scene.tile.y) % kThingBlock; }

// Blocks side by side.
uint tile_row() { return (before_tile().x + scene.tile.width + kThingBlock - 1u) / kThingBlock; }

uvec2 first_of_block(uvec2 block) { return kThingBlock * block - before_tile(); }

bool is_in_picture(uvec2 pixel) {
  uvec2 at = pixel + uvec2(scene.tile.x, scene.tile.y);
  return float(at.x) < scene.camera.width && float(at.y) < scene.camera.height;
}

// The last pixel of a block that is in the picture, from the block's first.
uvec2 block_span(uvec2 block) {
  uvec2 first = first_of_block(block) + uvec2(scene.tile.x, scene.tile.y);
  return min(uvec2(kThingBlock - 1u), uvec2(scene.camera.width, scene.camera.height) - 1u - first);
}

// Where a ray stands among those of the quads, 2 x 2 places each, of a square of so many: at the first place of a quad
// in the first half, at the second one in the other half. So all other places lie between rays of the square; of four
// quads, rays stand at 0, 2, 5 and 7. `last`: of the square's places.
uvec2 quad_ray(uvec2 quad, uint across, uvec2 last) {
  uvec2 second = uvec2(quad.x >= across / 2u ? 1u : 0u, quad.y >= across / 2u ? 1u : 0u);
  return min(2u * quad + second, max(last, 2u * quad));
}
