#version 460
#extension GL_GOOGLE_include_directive : require
// The mean extinction up to each slice of a row of the aerial volume: one thread a row, or a
// team that shares its slices.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/sky_table_ray.glsl"
#include "shared/aerial_volume.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 27) const uint kTeam = 1u;  // threads a row: a power of two up to 64
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D extinction_out;  // slices x rows

float slice_end(Ray ray, uint slice) {
  return slice_distance(scene.planet, ray, float(slice) / float(kExtinctionSlices - 1u));
}

// Optical depth up to the end of slices [first, last), given the depth before them; stores each mean if `stores`.
vec3 gather(vec3 depth, Ray ray, uint row, uint first, uint last, bool stores) {
  float from = first == 0u ? 0.0 : slice_end(ray, first - 1u);
  for (uint slice = first; slice < last; slice++) {
    float to = slice_end(ray, slice);
    if (to > from) {
      depth += scene_air_factors(part_of_ray(scene.planet, ray, from, to), 2u).depth;
      from = to;
    }
    if (stores) {
      vec3 mean = from > 0.0 ? depth / from : diffuse_air(densities_at(ray.h), equal_phases(0.0)).extinction;
      imageStore(extinction_out, ivec2(slice, row), vec4(mean, 1.0));
    }
  }
  return depth;
}

shared vec3 parts[64];

void main() {
  uint rows = kGroundRows + kLimbRows + kSkyRows;
  uint row = gl_GlobalInvocationID.x / kTeam;
  uint part = gl_GlobalInvocationID.x % kTeam;
  if (kTeam == 1u && row >= rows) {
    return;
  }
  Ray ray = table_ray(uvec2(0u, min(row, rows - 1u))).ray;
  uint first = part * kExtinctionSlices / kTeam;
  uint last = (part + 1u) * kExtinctionSlices / kTeam;
  vec3 depth = vec3(0.0);
  if (kTeam > 1u) {
    uint thread = gl_LocalInvocationIndex;
    parts[thread] = gather(depth, ray, row, first, last, false);
    barrier();
    for (uint i = 0u; i < part; i++) {
      depth += parts[thread - part + i];
    }
  }
  gather(depth, ray, row, first, last, row < rows);
}
