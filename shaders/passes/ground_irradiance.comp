#version 460
#extension GL_GOOGLE_include_directive : require
// Irradiance of the sky on level ground over (1 + mu_sun)/2, for a ground that reflects: one workgroup a texel, one
// thread a direction.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"

// Rays that leave the ground upward never end on it.
bool ground_reflects() { return false; }
vec3 fetch_ground_irradiance(float x) { return vec3(0.0); }

#include "physics/march.glsl"
#include "physics/irradiance.glsl"

layout(local_size_x = 64) in;  // kGroundIrradianceDirections
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D ground_irradiance_out;

shared vec3 radiance[kGroundIrradianceDirections];

void main() {
  ivec2 size = imageSize(ground_irradiance_out);
  int texel = int(gl_WorkGroupID.y);
  uint direction = gl_LocalInvocationID.x;
  float mu_sun = 2.0 * float(texel) / float(size.x - 1) - 1.0;
  Ray ray = irradiance_ray(scene.planet, mu_sun, direction);
  SunData unit_sun = scene.sun;
  unit_sun.irradiance = vec3(1.0);
  radiance[direction] =
      march(scene.planet, unit_sun, ray, kMultipleScatteringSteps, kStepsQuadratic, scene.multiple_scattering_scale)
          .radiance;
  barrier();
  if (direction == 0u) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < kGroundIrradianceDirections; i++) {
      sum += radiance[i];
    }
    imageStore(ground_irradiance_out, ivec2(texel, 0), vec4(sum * irradiance_weight(), 1.0));
  }
}
