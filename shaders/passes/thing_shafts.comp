#version 460
#extension GL_GOOGLE_include_directive : require
// The share of the light scattered once that the shadows of terrain leave, over the picture and distances up to
// shaded_length(): one thread a column of froxels, slice by slice away from the camera.
#include "shared/device.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/picture_ray.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/thing_volume.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 7) uniform writeonly image3D shafts_out;

const uint kParts = 2u;  // of a slice, whose share of the sun is taken one by one

void main() {
  uvec3 size = uvec3(imageSize(shafts_out));
  uvec2 cell = gl_GlobalInvocationID.xy;
  if (cell.x >= size.x || cell.y >= size.y) {
    return;
  }
  vec2 at = vec2(cell) / vec2(size.xy - 1u) * vec2(scene.camera.width, scene.camera.height);
  Sight sight = sight_of(vec3(0.0), view_ray(scene.camera, kProjection, at.x, at.y).direction);
  VolumeRay of = volume_ray(sight);
  Phases p = phases(seen_cosine(scene.sun, sight.ray.mu, sight.ray.nu));
  float shaded = max(shaded_length(sight), 0.0);
  float from = 0.0;
  // The walk ends at the ground, where altitudes end; froxels beyond it take it on.
  float way = max(min(shaded, sight.ray.length_), 1e-9);
  ShadowWalk walk = shadow_walk(scene.planet, sight.track, sight.ray, way);
  vec2 near = over_shadow(walk, 0.0);
  vec3 share = vec3(mean_sunlit(near, near, 1.0));
  vec3 all = vec3(0.0);
  vec3 lit = vec3(0.0);
  for (uint slice = 0u; slice < size.z; slice++) {
    if (slice > 0u) {
      float sunlit = 0.0;
      float to = shaded * shaft_distance(float(slice) / float(size.z - 1u));
      float width = (to - from) / float(kParts);
      for (uint i = 1u; i <= kParts; i++) {
        vec2 far = over_shadow(walk, (from + float(i) * width) / way);
        sunlit += mean_sunlit(near, far, 0.5 * width) / float(kParts);
        near = far;
      }
      vec3 next = single_up_to(of, p, to);
      from = to;
      lit += max(next - all, vec3(0.0)) * sunlit;
      all = next;
      share = min(lit / max(all, vec3(1e-30)), vec3(1.0));
    }
    imageStore(shafts_out, ivec3(cell, slice), vec4(share, 1.0));
  }
}
