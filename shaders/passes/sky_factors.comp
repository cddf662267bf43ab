#version 460
#extension GL_GOOGLE_include_directive : require
// The picture's light over view directions, factor by factor (physics/sky_table.glsl): one thread a direction, or
// a team that shares its steps.
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "shared/sky_table_ray.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 27) const uint kTeam = 1u;  // threads a ray: 1, 2, 4 or 8; 1 where the air is cut into shells
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D factors_out;
layout(push_constant, scalar) uniform Push {
  uint steps;
  float half_angle;  // of a cone around the picture's directions: other texels are not read
};

shared SkyFactors parts[64];

// Returns the whole ray's factors to the first of the threads that share the ray.
SkyFactors shared_sky_factors(Ray ray, uint part) {
  uint thread = gl_LocalInvocationIndex;
  uint panels = (steps + 1u) / 2u;
  parts[thread] = air_factors_between(scene.planet, scene.moments, ray, panels, part * panels / kTeam,
                                      (part + 1u) * panels / kTeam);
  barrier();
  SkyFactors factors = parts[thread];
  for (uint i = 1u; i < kTeam && part == 0u; i++) {
    factors = joined(factors, parts[thread + i]);
  }
  return with_ground(scene.planet, scene.moments, ray, factors);
}

void store_single(uint i, SkyFactors factors, uvec2 texel) {
  if (scatters(i)) {
    ivec2 at = ivec2(single_block(i) * kSkyColumns + texel.x, texel.y);
    imageStore(factors_out, at, vec4(factors.single[i] * scene.sun.irradiance, 1.0));
  }
}

#include "shared/stokes_blocks.glsl"

vec3 folded_light(uint i, SkyFactors factors, float nu) {
  return folded(i) ? factors.single[i] * medium_phase(i, nu) : vec3(0.0);
}

// No texel is left undefined: a lookup multiplies what it does not want by 0, which keeps a NaN.
void store_nothing(uvec2 texel) {
  int blocks = imageSize(factors_out).x / int(kSkyColumns);
  for (int block = 0; block < blocks; block++) {
    imageStore(factors_out, ivec2(block * int(kSkyColumns) + int(texel.x), texel.y), vec4(0.0));
  }
}

void main() {
  uvec2 texel = uvec2(gl_GlobalInvocationID.x / kTeam, gl_GlobalInvocationID.y);
  uint part = gl_GlobalInvocationID.x % kTeam;
  uint rows = kGroundRows + kLimbRows + kSkyRows;
  bool in_table = texel.x < kSkyColumns && texel.y < rows;
  bool outside = !in_table || !texel_is_read(texel, half_angle);
  if (outside && in_table && part == 0u) {
    store_nothing(texel);
  }
  if (kTeam == 1u && outside) {
    return;
  }
  // Assigned by component: SPIRV-Tools may put a folded vector of constants before its parts (core/gpu/specialize.cpp).
  TableRay at = table_ray(uvec2(min(texel.x, kSkyColumns - 1u), min(texel.y, rows - 1u)));
  Ray ray = at.ray;
  ray.length_ = outside ? 0.0 : ray.length_;  // the team takes no steps
  SkyFactors factors;
  if (kTeam == 1u) {
    factors = scene_sky_factors(ray, steps);
  } else {
    factors = shared_sky_factors(ray, part);
  }
  if (outside || part > 0u) {
    return;
  }
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    store_single(i, factors, texel);
  }
  float nu = seen_cosine(scene.sun, ray.mu, ray.nu);
  vec3 light = factors.diffuse;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    light += folded_light(i, factors, nu);
  }
  light *= scene.sun.irradiance / shared_carrier(section_of_row(texel.y), nu);
  imageStore(factors_out, ivec2(diffuse_block() * kSkyColumns + texel.x, texel.y), vec4(light, 1.0));
  store_stokes(diffuse_block() + 1u, factors, at.cos_azimuth, texel);
}
