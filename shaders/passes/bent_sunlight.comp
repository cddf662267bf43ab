#version 460
#extension GL_GOOGLE_include_directive : require
// Sunlight through air that bends it, over (lifted_sun(), h), above the table of seen directions.
#include "shared/device.glsl"
#include "shared/seen_sun.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D sunlight_out;

void main() {
  ivec2 size = textureSize(seen_lut, 0);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  vec2 unit = vec2(texel) / vec2(size - 1);
  TransmittanceState state = transmittance_state(scene.planet, unit.x, unit.y);
  SeenSun sun = seen_sun(state.h, sun_before_lift(state.h, state.mu));
  vec3 depth = optical_depth_to_top(scene.planet, state.h, sun.mu, kTransmittanceSteps);
  imageStore(sunlight_out, texel, vec4(exp(-depth) * sun.spread, 1.0));
  imageStore(sunlight_out, texel + ivec2(0, size.y), texelFetch(seen_lut, texel, 0));
}
