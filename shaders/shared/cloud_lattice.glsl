// Rays through clouds at every second pixel each way, and pixels between four of them. The lattice is that of the whole
// picture in every tile. A ray keeps what clouds make of the light behind it, whatever that is: stars and the planet's
// edge stay sharp.

struct LatticeRay {
  vec3 sent;      // PastCloud
  float through;
  vec3 share;
  float end;      // kEnds...
  vec3 taken;
};

const float kEndsInSky = 0.0;
const float kEndsOnGround = 1.0;
const float kEndsOutside = 2.0;  // of the projection

uint lattice_row(uint width) { return width / 2u + 2u; }

// The pixel of the tile at hand that a ray of the lattice goes through; it may stand outside of the tile.
uvec2 lattice_pixel(uvec2 at) {
  uvec2 first = uvec2(scene.tile.x, scene.tile.y);
  return 2u * (at + first / 2u) - first;
}
