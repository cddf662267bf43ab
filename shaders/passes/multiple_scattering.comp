#version 460
#extension GL_GOOGLE_include_directive : require
// Isotropic multiple scattering over (mu_sun, h): one workgroup a texel, one thread a direction, then their mean.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "physics/multiple_scattering.glsl"

layout(local_size_x = 64) in;  // kMultipleScatteringDirections
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D multiple_scattering_out;

shared vec3 second_order[kMultipleScatteringDirections];
shared vec3 transfer[kMultipleScatteringDirections];

void main() {
  ivec2 size = imageSize(multiple_scattering_out);
  ivec2 texel = ivec2(gl_WorkGroupID.yz);
  uint direction = gl_LocalInvocationID.x;
  vec2 unit = vec2(texel) / vec2(size - 1);
  ScatteringState state = scattering_state(scene.planet, unit.x, unit.y);
  Ray ray = gather_ray(scene.planet, state.h, state.mu_sun, direction);
  ScatteringGather gather = gather_scattering(scene.planet, scene.sun, ray, kMultipleScatteringSteps);
  second_order[direction] = gather.second_order;
  transfer[direction] = gather.transfer;
  barrier();
  if (direction == 0u) {
    vec3 second_order_sum = vec3(0.0);
    vec3 transfer_sum = vec3(0.0);
    for (uint i = 0u; i < kMultipleScatteringDirections; i++) {
      second_order_sum += second_order[i];
      transfer_sum += transfer[i];
    }
    float n = float(kMultipleScatteringDirections);
    imageStore(multiple_scattering_out, texel, vec4(sum_of_orders(second_order_sum / n, transfer_sum / n), 1.0));
  }
}
