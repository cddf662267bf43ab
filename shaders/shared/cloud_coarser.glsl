// The eight cells of a coarser grid around the middle of a cell; both grids repeat themselves in x and y.

const float kDrySpace = 1e-6;  // 1/km, what a cell without water counts for, where none around has any

struct EightCells {
  uvec3 near;
  uvec3 far;
  vec3 part;  // of the way from near to far
};

EightCells coarser_cells_around(uvec3 cell, uvec3 size, uvec3 coarser) {
  vec3 place = (vec3(cell) + 0.5) / vec3(size) * vec3(coarser) - 0.5;
  place.z = clamp(place.z, 0.0, float(coarser.z - 1u));
  vec3 low = floor(place);
  EightCells around;
  around.part = place - low;
  around.near = uvec3(ivec3(low) + ivec3(coarser)) % coarser;
  around.far = (around.near + 1u) % coarser;
  around.near.z = uint(low.z);
  around.far.z = min(around.near.z + 1u, coarser.z - 1u);
  return around;
}

bvec3 is_far(uint n) { return bvec3((n & 1u) != 0u, (n & 2u) != 0u, (n & 4u) != 0u); }

float coarser_share(EightCells around, uint n) {
  vec3 share = mix(1.0 - around.part, around.part, is_far(n));
  return share.x * share.y * share.z;
}

uint coarser_cell(EightCells around, uvec3 coarser, uint n) {
  uvec3 at = mix(around.near, around.far, is_far(n));
  return (at.z * coarser.y + at.y) * coarser.x + at.x;
}
