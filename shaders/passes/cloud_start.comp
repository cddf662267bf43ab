#version 460
#extension GL_GOOGLE_include_directive : require
// Moments of the light in a cloud's cells from those found on coarser cells, to begin sweeps with: between the coarser
// cells by the water that they hold. One thread a cell of the list.
#include "shared/cloud_cells.glsl"
#include "shared/cloud_coarser.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 3) readonly buffer List { uint values[]; } lit_cells;
layout(scalar, set = 0, binding = 4) readonly buffer Found { float values[]; } found;
layout(scalar, set = 0, binding = 6) writeonly buffer Moments { float values[]; } moments_out;
layout(scalar, set = 0, binding = 8) readonly buffer CoarserCells { float values[]; } coarser_cells;
layout(push_constant, scalar) uniform Push {
  uint count;  // of the list
  uvec3 size;
  uvec3 coarser;
};

void main() {
  if (gl_GlobalInvocationID.x >= count) {
    return;
  }
  uint at = lit_cells.values[gl_GlobalInvocationID.x];
  uvec3 cell = uvec3(at % size.x, at / size.x % size.y, at / (size.x * size.y));
  EightCells around = coarser_cells_around(cell, size, coarser);
  for (uint q = 0u; q < kCloudMoments; q++) {
    float sum = 0.0;
    float water = 0.0;
    for (uint n = 0u; n < 8u; n++) {
      uint from = coarser_cell(around, coarser, n);
      float weight = coarser_share(around, n) * max(coarser_cells.values[from], kDrySpace);
      sum += weight * found.values[q * (coarser.x * coarser.y * coarser.z) + from];
      water += weight;
    }
    moments_out.values[q * (size.x * size.y * size.z) + at] = sum / water;
  }
}
