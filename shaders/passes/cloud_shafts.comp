#version 460
#extension GL_GOOGLE_include_directive : require
// The share of the air's light that clouds leave, over the picture and the distances of shaded_distance(): one thread a
// column of froxels, slice by slice away from the camera.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/picture_ray.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/volume_fetch.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "physics/cloud_march.glsl"
#include "shared/cloud_shade.glsl"
#include "shared/cloud_shafts.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 26) uniform writeonly image3D shafts_out;

const uint kStepsAbove = 8u;  // up to where a ray from above the cloud falls below its top

layout(push_constant, scalar) uniform Push { uint parts; };  // of a slice

void main() {
  uvec3 size = uvec3(imageSize(shafts_out));
  uvec2 cell = gl_GlobalInvocationID.xy;
  if (cell.x >= size.x || cell.y >= size.y) {
    return;
  }
  vec2 at = vec2(cell) / vec2(size.xy - 1u) * vec2(scene.camera.width, scene.camera.height);
  vec3 direction = view_ray(scene.camera, kProjection, at.x, at.y).direction;
  Ray ray = air_ray(direction);
  FactorPlace of = factor_place(direction);
  ShadedWay way = shaded_way(scene.planet.ground_radius, highest_cloud(), ray.h, ray.mu, max(ray.length_, 0.0));
  ShadedAir air = no_shaded_air();
  float before = way_to_air(direction);
  uint steps = way.from > 0.0 ? kStepsAbove : 0u;
  for (uint i = 1u; i <= steps; i++) {
    float share_of_way = float(i) / float(steps);
    air = shaded_up_to(air, ray, of, direction, before, way.from * share_of_way * share_of_way, parts);
  }
  // From below the top the first slice is of no length: it has the share of the second.
  uint first = steps > 0u ? 0u : 1u;
  for (uint slice = first; slice < size.z; slice++) {
    if (slice > 0u) {
      float to = shaded_distance(way, float(slice) / float(size.z - 1u));
      air = shaded_up_to(air, ray, of, direction, before, to, parts);
    }
    vec4 share = vec4(share_left(air), 1.0);
    if (slice == 1u && first == 1u) {
      imageStore(shafts_out, ivec3(cell, 0), share);
    }
    imageStore(shafts_out, ivec3(cell, slice), share);
  }
}
