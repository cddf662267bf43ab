#version 460
#extension GL_GOOGLE_include_directive : require
// Light from a set of directions up to a set of distances at altitudes among terrain, as if there were none, for a sun
// of irradiance 1: one thread a direction and altitude. Blocks of directions side by side: scattered once, other
// light, transmittance. The last slice is the whole ray, the ground behind it.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/things.glsl"
#include "shared/thing_light.h"
#include "physics/thing_open.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image3D open_out;
layout(push_constant, scalar) uniform Push { uint steps; };  // of the whole ray

void store(uint block, uint i, uint row, uint slice, vec3 light) {
  imageStore(open_out, ivec3(block * kLightDirections + i, row, slice), vec4(light, 1.0));
}

void store_slice(SkyFactors factors, Phases p, uint i, uint row, uint slice) {
  vec3 single = vec3(0.0);
  UNROLL for (uint m = 0u; m < kMaxMedia; m++) {
    single += m < medium_count() ? factors.single[m] * p.of[m] : vec3(0.0);
  }
  store(kOpenSingle, i, row, slice, single);
  store(kOpenDiffuse, i, row, slice, factors.diffuse);
  store(kOpenThrough, i, row, slice, factors.transmittance);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  uint row = gl_GlobalInvocationID.y;
  if (i >= kLightDirections || row >= kOpenRows) {
    return;
  }
  TerrainData t = terrain_shape();
  vec3 sun = scene.sun.direction;
  vec3 direction = light_direction(i, false, sun);
  float h = open_altitude(t, float(row));
  Ray ray = ray_in_atmosphere(scene.planet, h, direction.y, sun.y, dot(direction, sun));
  float reach = open_reach(t, direction.y);
  Phases p = phases(ray.nu);
  SkyFactors factors = no_air();
  float from = 0.0;
  // The whole ray is one more turn of the loop, so that the code of a march stands once.
  for (uint slice = 0u; slice <= kOpenSlices + 1u; slice++) {
    bool whole = slice > kOpenSlices;
    float to = clamp(open_distance(reach, float(slice)), from, max(ray.length_, 0.0));
    Ray part = ray;
    if (!whole) {
      part = part_of_ray(scene.planet, ray, from, to);
    }
    if (whole || to > from) {
      SkyFactors air = scene_air_factors(part, whole ? steps : 2u);
      if (whole) {
        factors = no_air();
      }
      factors = joined(factors, air);
      factors.diffuse += whole ? scene_ground_light(ray, air.transmittance) : vec3(0.0);
    }
    from = to;
    store_slice(factors, p, i, row, slice);
  }
}
