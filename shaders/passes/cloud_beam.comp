#version 460
#extension GL_GOOGLE_include_directive : require
// The sun's light in a cloud's coarse cells over that above the cloud, delta-scaled: the mean over their fine cells by
// what these take out. One thread a cell.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 2) writeonly buffer Beam { float values[]; } beam_out;

void main() {
  CloudData c = cloud();
  uvec3 cells = uvec3(c.coarse_x, c.coarse_y, c.coarse_z);
  uint at = gl_GlobalInvocationID.x;
  if (at >= cells.x * cells.y * cells.z) {
    return;
  }
  uvec3 cell = uvec3(at % cells.x, at / cells.x % cells.y, at / (cells.x * cells.y));
  uvec3 parts = (uvec3(c.fine_x, c.fine_y, c.fine_z) + cells - 1u) / cells;
  float all = 0.0;
  float lit = 0.0;
  for (uint i = 0u; i < parts.x * parts.y * parts.z; i++) {
    vec3 part = vec3(i % parts.x, i / parts.x % parts.y, i / (parts.x * parts.y)) + 0.5;
    vec3 place = (vec3(cell) + part / vec3(parts)) / vec3(cells);
    float weight = density_at(place) + 1e-6;
    all += weight;
    lit += weight * exp(-c.scale * sun_depth_at(place));
  }
  beam_out.values[at] = lit / all;
}
