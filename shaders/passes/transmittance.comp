#version 460
#extension GL_GOOGLE_include_directive : require
// Transmittance to the top of the atmosphere over (mu, h), and bending; the texel centres at the edges hold the ends of
// the ranges.
#include "shared/device.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D transmittance_out;

void main() {
  ivec2 size = imageSize(transmittance_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  vec2 unit = vec2(texel) / vec2(size - 1);
  TransmittanceState state = transmittance_state(scene.planet, unit.x, unit.y);
  vec3 depth = optical_depth_to_top(scene.planet, state.h, state.mu, kTransmittanceSteps);
  float bending = bends_light() ? bending_to_top(scene.planet, state.h, state.mu, kBendingSteps) : 1.0;
  imageStore(transmittance_out, texel, vec4(exp(-depth), bending));
}
