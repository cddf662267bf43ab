#version 460
#extension GL_GOOGLE_include_directive : require
// sky_factors.comp's table with the shared block split: one block for each folded medium, for the diffuse light and for
// the ground. Interpolation is linear, so these blocks still add up to the shared one.
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
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D factors_out;
layout(push_constant, scalar) uniform Push { uint steps; };

#include "shared/stokes_blocks.glsl"

void store(uint block, uvec2 texel, vec3 light) {
  imageStore(factors_out, ivec2(block * kSkyColumns + texel.x, texel.y), vec4(light * scene.sun.irradiance, 1.0));
}

void store_single(uint i, SkyFactors factors, uvec2 texel, float nu) {
  if (scatters(i)) {
    vec3 phase = folded(i) ? medium_phase(i, nu) / shared_carrier(section_of_row(texel.y), nu) : vec3(1.0);
    store(single_block(i), texel, factors.single[i] * phase);
  }
}

void main() {
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (texel.x >= kSkyColumns || texel.y >= kGroundRows + kLimbRows + kSkyRows) {
    return;
  }
  TableRay at = table_ray(texel);
  Ray ray = at.ray;
  ApartFactors factors = scene_apart_factors(ray, steps);
  float nu = seen_cosine(scene.sun, ray.mu, ray.nu);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    store_single(i, factors.air, texel, nu);
  }
  float carrier = shared_carrier(section_of_row(texel.y), nu);
  store(diffuse_block(), texel, factors.air.diffuse / carrier);
  store(diffuse_block() + 1u, texel, factors.ground / carrier);
  store_stokes(diffuse_block() + 2u, factors.air, at.cos_azimuth, texel);
}
