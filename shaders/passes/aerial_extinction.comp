#version 460
#extension GL_GOOGLE_include_directive : require
// The mean extinction up to each slice of a row of the aerial volume: one thread a row.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/sky_table_ray.glsl"
#include "shared/aerial_volume.glsl"

layout(local_size_x = 8) in;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D extinction_out;  // slices x rows

void main() {
  uint row = gl_GlobalInvocationID.x;
  if (row >= kGroundRows + kLimbRows + kSkyRows) {
    return;
  }
  Ray ray = table_ray(uvec2(0u, row));
  vec3 depth = vec3(0.0);
  float from = 0.0;
  for (uint slice = 0u; slice < kExtinctionSlices; slice++) {
    float to = slice_distance(scene.planet, ray, float(slice) / float(kExtinctionSlices - 1u));
    if (to > from) {
      depth += scene_air_factors(part_of_ray(scene.planet, ray, from, to), 2u).depth;
      from = to;
    }
    vec3 mean = from > 0.0 ? depth / from : diffuse_air_over(ray.h, 0.0, equal_phases(0.0)).extinction;
    imageStore(extinction_out, ivec2(slice, row), vec4(mean, 1.0));
  }
}
