#version 460
#extension GL_GOOGLE_include_directive : require
// The share of the air's light beside that scattered once which terrain leaves, over the picture and distances up to
// dimmed_reach(): one thread a column of froxels, slice by slice away from the camera.
#define AIRLIGHT_COARSE_SLOPES
#include "shared/device.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/picture_ray.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/thing_volume.glsl"
#include "shared/thing_dimmed.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 7) uniform writeonly image3D dimmed_out;

void main() {
  uvec3 size = uvec3(imageSize(dimmed_out));
  uvec2 cell = gl_GlobalInvocationID.xy;
  if (cell.x >= size.x || cell.y >= size.y) {
    return;
  }
  vec2 at = vec2(cell) / vec2(size.xy - 1u) * vec2(scene.camera.width, scene.camera.height);
  Sight sight = sight_of(vec3(0.0), view_ray(scene.camera, kProjection, at.x, at.y).direction);
  VolumeRay of = volume_ray(sight);
  float reach = dimmed_reach();
  float from = 0.0;
  vec3 share = dimmed_in_step(sight, 0.0, 0.0);
  vec3 all = vec3(0.0);
  vec3 left = vec3(0.0);
  for (uint slice = 0u; slice < size.z; slice++) {
    if (slice > 0u) {
      float to = reach * dimmed_distance(float(slice) / float(size.z - 1u));
      vec3 next = max(diffuse_up_to(of, to), all);
      left += (next - all) * dimmed_in_step(sight, from, to);
      share = left / max(next, vec3(1e-20));  // of the sun's irradiance: less is no light
      all = next;
      from = to;
    }
    imageStore(dimmed_out, ivec3(cell, slice), vec4(share, 1.0));
  }
}
