#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud's coarse cells send, as an image of blocks side by side (shared/cloud_blocks.glsl): the sun's light by
// harmonic, that of sky and ground in harmonics 0, 2 and 6, found on coarser cells.
#include "shared/cloud_cells.glsl"
#include "shared/cloud_blocks.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 2) readonly buffer Scattering { CloudScattering value; } scattering;
layout(scalar, set = 0, binding = 3) readonly buffer Sun { float values[]; } sun;
layout(scalar, set = 0, binding = 4) readonly buffer Sky { float values[]; } sky;
layout(scalar, set = 0, binding = 5) readonly buffer Ground { float values[]; } ground;
layout(set = 0, binding = 6, rgba32f) uniform writeonly image3D source_out;
layout(push_constant, scalar) uniform Push {
  uvec3 size;
  uvec3 coarser;  // cells of sky and ground
};

// Places of the eight coarser cells around a place, and their shares.
uint index_of(uvec3 cell) { return (cell.z * coarser.y + cell.y) * coarser.x + cell.x; }

float coarser_value(bool of_sky, uint q, uvec3 cell) {
  uint all = coarser.x * coarser.y * coarser.z;
  uint at = q * all + index_of(cell);
  return of_sky ? sky.values[at] : ground.values[at];
}

float interpolated(bool of_sky, uint q, uvec3 cell) {
  vec3 place = (vec3(cell) + 0.5) / vec3(size) * vec3(coarser) - 0.5;
  place.z = clamp(place.z, 0.0, float(coarser.z - 1u));
  vec3 low = floor(place);
  vec3 part = place - low;
  uvec3 near = uvec3(ivec3(low) + ivec3(coarser)) % coarser;
  uvec3 far = (near + 1u) % coarser;
  near.z = uint(low.z);
  far.z = min(near.z + 1u, coarser.z - 1u);
  float sum = 0.0;
  for (uint n = 0u; n < 8u; n++) {
    bvec3 is_far = bvec3((n & 1u) != 0u, (n & 2u) != 0u, (n & 4u) != 0u);
    vec3 share = mix(1.0 - part, part, is_far);
    sum += share.x * share.y * share.z * coarser_value(of_sky, q, mix(near, far, is_far));
  }
  return sum;
}

float sun_value(uint q, uvec3 cell) { return sun.values[((q * size.z + cell.z) * size.y + cell.y) * size.x + cell.x]; }

float value_of(uint i, uvec3 cell) {
  if (i < kCloudSky) {
    return scattering.value.kept[i] * sun_value(i, cell);
  }
  if (i >= kCloudGround + 3u) {
    return 0.0;
  }
  uint rest = (i - kCloudSky) % 3u;
  uint q = rest == 0u ? 0u : (rest == 1u ? 2u : 6u);
  return scattering.value.kept[q] * interpolated(i < kCloudGround, q, cell);
}

void main() {
  uvec3 at = gl_GlobalInvocationID;
  uint columns = size.x + 1u;
  if (at.x >= columns * kCloudBlocks || at.y > size.y || at.z >= size.z) {
    return;
  }
  uint block = at.x / columns;
  uvec3 cell = uvec3((at.x % columns + size.x - 1u) % size.x, (at.y + size.y - 1u) % size.y, at.z);
  vec4 texel;
  texel.x = value_of(4u * block, cell);
  texel.y = value_of(4u * block + 1u, cell);
  texel.z = value_of(4u * block + 2u, cell);
  texel.w = value_of(4u * block + 3u, cell);
  imageStore(source_out, ivec3(at), texel);
}
