#version 460
#extension GL_GOOGLE_include_directive : require
// Moments of the light in a cloud's cells after a sweep, accelerated by Chebyshev's iteration: one thread a cell of the
// list.
#include "shared/cloud_cells.glsl"
#include "physics/cloud_harmonics.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 3) readonly buffer List { uint values[]; } lit_cells;
layout(scalar, set = 0, binding = 5) readonly buffer Means { float values[]; } means;
layout(scalar, set = 0, binding = 6) buffer Moments { float values[]; } moments;
layout(scalar, set = 0, binding = 7) buffer Changes { float values[]; } changes;
layout(push_constant, scalar) uniform Push {
  uint count;  // of the list
  uint cells;  // of the grid
  float step;
  float momentum;
};

void main() {
  if (gl_GlobalInvocationID.x >= count) {
    return;
  }
  uint at = lit_cells.values[gl_GlobalInvocationID.x];
  CloudMoments sums;
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    sums.of[q] = 0.0;
  }
  for (uint r = 0u; r < kCloudRings; r++) {
    CloudRing ring;
    UNROLL for (uint a = 0u; a < 8u; a++) {
      ring.of[a] = means.values[(8u * r + a) * cells + at];
    }
    float z = ordinates.values[8u * r].direction.z;
    sums = with_ring(sums, ring, ring_is_turned(z), z, ordinates.values[8u * r].weight);
  }
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    uint index = q * cells + at;
    float now = moments.values[index];
    float change = sums.of[q] - now + momentum * changes.values[index];
    changes.values[index] = change;
    moments.values[index] = now + step * change;
  }
}
