#version 460
#extension GL_GOOGLE_include_directive : require
// What each of a cloud's cells sends along each ordinate, and how that rises along the way through the cell: one thread
// a cell of the list.
#include "shared/cloud_cells.glsl"
#include "physics/cloud_harmonics.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 2) readonly buffer Scattering { CloudScattering value; } scattering;
layout(scalar, set = 0, binding = 3) readonly buffer List { uint values[]; } lit_cells;
layout(scalar, set = 0, binding = 4) readonly buffer Beam { float values[]; } beam;  // sunlight in the cells
layout(scalar, set = 0, binding = 5) readonly buffer Extinctions { float values[]; } extinctions;  // scaled, 1/km
layout(scalar, set = 0, binding = 6) readonly buffer Moments { float values[]; } moments;
layout(scalar, set = 0, binding = 8) writeonly buffer Sources { vec2 values[]; } sources_out;
layout(push_constant, scalar) uniform Push {
  uint count;  // of the list
  uvec3 size;
  vec3 cell;  // sides, km
  float sun;  // 1: the sun shines
};

// Neighbours: east, west, north, south, up, down.
const uint kSides = 6u;

CloudMoments emission(uint at) {
  uint cells = size.x * size.y * size.z;
  float lit = sun * beam.values[at];
  CloudMoments sums;
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    sums.of[q] = (moments.values[q * cells + at] + scattering.value.sunlight[q] * lit) * scattering.value.kept[q];
  }
  return sums;
}

// The cell on a side; at top and base the cell itself.
uint neighbour(uint at, uint side) {
  uint plane = size.x * size.y;
  uint x = at % size.x;
  uint y = at / size.x % size.y;
  if (side < 2u) {
    return at - x + repeated(x + (side == 0u ? 1u : size.x - 1u), size.x);
  }
  if (side < 4u) {
    return at - y * size.x + repeated(y + (side == 2u ? 1u : size.y - 1u), size.y) * size.x;
  }
  return side == 4u ? (at + plane < size.z * plane ? at + plane : at) : (at >= plane ? at - plane : at);
}

float along(vec3 direction, uint side) {
  float part = side < 2u ? direction.x : (side < 4u ? direction.y : direction.z);
  return (side & 1u) == 0u ? part : -part;
}

void main() {
  if (gl_GlobalInvocationID.x >= count) {
    return;
  }
  uint at = lit_cells.values[gl_GlobalInvocationID.x];
  uint all = size.x * size.y * size.z;
  CloudMoments here = emission(at);
  float extinction = extinctions.values[at];
  CloudMoments rises[kSides];  // up to the face, per km
  for (uint n = 0u; n < kSides; n++) {
    uint other = neighbour(at, n);
    CloudMoments there = emission(other);
    // At the face the source is what carries the same flux through both cells by diffusion.
    float near = extinction / max(extinction + extinctions.values[other], 1e-20);
    float share = 2.0 * near / (n < 2u ? cell.x : (n < 4u ? cell.y : cell.z));
    UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
      rises[n].of[q] = share * (there.of[q] - here.of[q]);
    }
  }
  for (uint r = 0u; r < kCloudRings; r++) {
    float z = ordinates.values[8u * r].direction.z;
    bool turned = ring_is_turned(z);
    CloudRing source = ring_of(here, turned, z);
    CloudRing slope;
    float ways[8];
    for (uint a = 0u; a < 8u; a++) {
      vec3 direction = ordinates.values[8u * r + a].direction;
      ways[a] = sweep_way(direction, cell, sweep_axis(direction, cell * vec3(size), cell));
      slope.of[a] = 0.0;
    }
    for (uint n = 0u; n < kSides; n++) {
      CloudRing rise = ring_of(rises[n], turned, z);
      UNROLL for (uint a = 0u; a < 8u; a++) {
        slope.of[a] += ways[a] * max(along(ordinates.values[8u * r + a].direction, n), 0.0) * rise.of[a];
      }
    }
    UNROLL for (uint a = 0u; a < 8u; a++) {
      float most = 2.0 * max(source.of[a], 0.0);  // so that nowhere on the way the source is below 0
      sources_out.values[(8u * r + a) * all + at] = vec2(source.of[a], clamp(slope.of[a], -most, most));
    }
  }
}
