#version 460
#extension GL_GOOGLE_include_directive : require
// The sky's irradiance on level ground over (1 + mu_sun)/2, from the table of moments: one thread a texel.
#include "shared/device.glsl"
#include "shared/moment_table.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D ground_irradiance_out;

void main() {
  uint texel = gl_GlobalInvocationID.x;
  uint columns = uint(imageSize(ground_irradiance_out).x);
  if (texel >= columns) {
    return;
  }
  float mu_sun = 2.0 * float(texel) / float(columns - 1u) - 1.0;
  imageStore(ground_irradiance_out, ivec2(texel, 0), vec4(moment_ground_irradiance(scene.moments, mu_sun), 1.0));
}
