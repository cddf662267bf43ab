// The night sky's table (core/night/night.h).
#include "shared/night.h"

layout(set = 0, binding = 4) uniform sampler2D night_sky;

vec3 night_table(float x, float y) {
  return texture(night_sky, vec2((x + 0.5) / float(kNightSide), (y + 0.5) / float(kNightSide + 1u))).rgb;
}

vec3 night_texel(uint x, uint y) { return texelFetch(night_sky, ivec2(x, y), 0).rgb; }

#include "physics/night_sky.glsl"
