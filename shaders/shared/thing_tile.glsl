// The blocks of pixels of a tile, of which 2 x 2 are a square. Squares are those of the whole picture in every tile, so
// a tile may begin and end within one. Pixels of a block before the tile have numbers below 0, as unsigned ones wrap.

layout(constant_id = 38) const uint kTiles = kTilesAll;

// Pixels between the first square's and the tile's first.
uvec2 before_tile() { return uvec2(scene.tile.x, scene.tile.y) % kThingSquare; }

// Blocks that hold so many pixels from the first block's first.
uint whole_blocks(uint pixels) {
  return kThingSquare / kThingBlock * ((pixels + kThingSquare - 1u) / kThingSquare);
}

// Blocks side by side.
uint tile_row() { return whole_blocks(before_tile().x + scene.tile.width); }

uvec2 first_of_block(uvec2 block) { return kThingBlock * block - before_tile(); }

bool is_in_picture(uvec2 pixel) {
  uvec2 at = pixel + uvec2(scene.tile.x, scene.tile.y);
  return float(at.x) < scene.camera.width && float(at.y) < scene.camera.height;
}

// The last pixel in the picture, from the first, of so many from that of a block on.
uvec2 span_from(uvec2 block, uint pixels) {
  uvec2 first = first_of_block(block) + uvec2(scene.tile.x, scene.tile.y);
  return min(uvec2(pixels - 1u), uvec2(scene.camera.width, scene.camera.height) - 1u - first);
}

uvec2 block_span(uvec2 block) { return span_from(block, kThingBlock); }

// Where a ray stands among those of the quads, 2 x 2 places each, of a square of so many: at the first place of a quad
// in the first half, at the second one in the other half. So all other places lie between rays of the square; of four
// quads, rays stand at 0, 2, 5 and 7. `last`: of the square's places.
uvec2 quad_ray(uvec2 quad, uint across, uvec2 last) {
  uvec2 second = uvec2(quad.x >= across / 2u ? 1u : 0u, quad.y >= across / 2u ? 1u : 0u);
  return min(2u * quad + second, max(last, 2u * quad));
}
