#version 460
#extension GL_GOOGLE_include_directive : require
// The mean extinction up to each slice of a row of the aerial volume, and that by forward peaks, which it leaves out:
// one thread a row, or a team that shares its slices.
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
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2D peaks_out;       // likewise

struct Depths {
  vec3 depth;
  vec3 peaks;
};

float slice_end(Ray ray, uint slice) {
  return slice_distance(scene.planet, ray, float(slice) / float(kExtinctionSlices - 1u));
}

void store(Depths sum, Ray ray, uint row, uint slice, float to) {
  DiffuseAir start = diffuse_air(densities_at(ray.h), equal_phases(0.0));
  vec3 mean = to > 0.0 ? sum.depth / to : start.extinction;
  vec3 peaks = to > 0.0 ? sum.peaks / to : start.peaks;
  imageStore(extinction_out, ivec2(slice, row), vec4(mean, 1.0));
  imageStore(peaks_out, ivec2(slice, row), vec4(peaks, 1.0));
}

// Optical depths up to the end of slices [first, last), given those before them; stores each mean if `stores`.
Depths gather(Depths sum, Ray ray, uint row, uint first, uint last, bool stores) {
  float from = first == 0u ? 0.0 : slice_end(ray, first - 1u);
  for (uint slice = first; slice < last; slice++) {
    float to = slice_end(ray, slice);
    if (to > from) {
      SkyFactors air = scene_air_factors(part_of_ray(scene.planet, ray, from, to), 2u);
      sum.depth += air.depth;
      sum.peaks += air.peaks;
    }
    from = max(from, to);
    if (stores) {
      store(sum, ray, row, slice, from);
    }
  }
  return sum;
}

shared Depths parts[64];

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
  Depths before = Depths(vec3(0.0), vec3(0.0));
  if (kTeam > 1u) {
    uint thread = gl_LocalInvocationIndex;
    Depths own = gather(before, ray, row, first, last, false);
    parts[thread] = own;
    barrier();
    for (uint i = 0u; i < part; i++) {
      before.depth += parts[thread - part + i].depth;
      before.peaks += parts[thread - part + i].peaks;
    }
    if (kExtinctionSlices <= kTeam) {
      if (row < rows && first < last) {
        store(Depths(before.depth + own.depth, before.peaks + own.peaks), ray, row, first, slice_end(ray, first));
      }
      return;
    }
  }
  gather(before, ray, row, first, last, row < rows);
}
