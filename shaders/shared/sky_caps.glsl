// What bodies hide of the sky as a sampler, sizes of caps side by side.
#include "shared/thing_light.h"

layout(set = 0, binding = 46) uniform sampler2D caps_lut;  // sky_caps.comp; any image where no bodies stand

vec3 fetch_cap(uint block, float x, float y, uint size) {
  vec2 cells = vec2(kCapAngles, kCapTurns);
  vec2 at = vec2(float(size), float(block)) * cells + 0.5 + vec2(x, y) * (cells - 1.0);
  return textureLod(caps_lut, at / (cells * vec2(float(kCapSizes), 2.0)), 0.0).rgb;
}

#include "physics/sky_caps.glsl"
