#version 460
#extension GL_GOOGLE_include_directive : require
// The view march on tables made by the host, over an array of rays; parity_test.cpp compares it with the host's.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;

struct RayArguments {
  float h, mu, mu_sun, nu;
};
layout(scalar, set = 0, binding = 8) readonly buffer Rays { RayArguments values[]; } rays;
layout(scalar, set = 0, binding = 9) writeonly buffer Paths { PathRadiance values[]; } paths;
layout(push_constant, scalar) uniform Push {
  uint steps;
};

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < rays.values.length()) {
    RayArguments x = rays.values[i];
    Ray ray = ray_in_atmosphere(scene.planet, x.h, x.mu, x.mu_sun, x.nu);
    paths.values[i] =
        march(scene.planet, scene.sun, ray, steps, kStepDistribution, scene.multiple_scattering_scale);
  }
}
