#version 460
#extension GL_GOOGLE_include_directive : require
// Moments of the light in a cloud's cells after a sweep, accelerated by Chebyshev's iteration, and the sources of the
// next sweep: one thread a cell of the list.
#include "shared/cloud_cells.glsl"
#include "physics/cloud_harmonics.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 57) const uint kCloudStart = 0u;  // 1: before the first sweep, when there are no means
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 2) readonly buffer Scattering { CloudScattering value; } scattering;
layout(scalar, set = 0, binding = 3) readonly buffer List { uint values[]; } lit_cells;
layout(scalar, set = 0, binding = 4) readonly buffer Beam { float values[]; } beam;  // sunlight in the cells
layout(scalar, set = 0, binding = 5) readonly buffer Means { float values[]; } means;
layout(scalar, set = 0, binding = 6) buffer Moments { float values[]; } moments;
layout(scalar, set = 0, binding = 7) buffer Changes { float values[]; } changes;
layout(scalar, set = 0, binding = 8) writeonly buffer Sources { float values[]; } sources_out;
layout(push_constant, scalar) uniform Push {
  uint count;  // of the list
  uint cells;  // of the grid
  float step;
  float momentum;
  float sun;  // 1: the sun shines
};

const uint kRings = 4u;

void main() {
  if (gl_GlobalInvocationID.x >= count) {
    return;
  }
  uint at = lit_cells.values[gl_GlobalInvocationID.x];
  CloudMoments sums;
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    sums.of[q] = 0.0;
  }
  for (uint r = 0u; r < kRings && kCloudStart == 0u; r++) {
    CloudRing ring;
    UNROLL for (uint a = 0u; a < 8u; a++) {
      ring.of[a] = means.values[(8u * r + a) * cells + at];
    }
    sums = with_ring(sums, ring, ordinates.values[8u * r].direction.z, ordinates.values[8u * r].weight);
  }
  float lit = sun * beam.values[at];
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    uint index = q * cells + at;
    float now = moments.values[index];
    float change = sums.of[q] - now + momentum * changes.values[index];
    now += step * change;
    changes.values[index] = change;
    moments.values[index] = now;
    sums.of[q] = (now + scattering.value.sunlight[q] * lit) * scattering.value.kept[q];
  }
  for (uint r = 0u; r < kRings; r++) {
    CloudRing ring = ring_of(sums, ordinates.values[8u * r].direction.z);
    UNROLL for (uint a = 0u; a < 8u; a++) {
      sources_out.values[(8u * r + a) * cells + at] = ring.of[a];
    }
  }
}
