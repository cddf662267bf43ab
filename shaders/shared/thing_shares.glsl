#ifndef AIRLIGHT_THING_SHARES
#define AIRLIGHT_THING_SHARES
// The shares of light among terrain as samplers (physics/thing_shares.glsl): the layers of air one below the other, and
// below them those of the surface as the air needs them, in two blocks side by side; and finer ones of the surface.

#include "shared/thing_light.h"

layout(set = 0, binding = 19) uniform sampler2D shares_lut;

vec4 share_texel(uint block, uint layer, vec2 place) {
  vec2 size = vec2(textureSize(shares_lut, 0));
  vec2 cells = size / vec2(2.0, float(kLightLayers + 1u));
  vec2 at = vec2(float(block), float(layer)) * cells + 0.5 + place * (cells - 1.0);
  return textureLod(shares_lut, at / size, 0.0);
}

#ifdef AIRLIGHT_IN_ROUNDS
// The shares are those of the round before; before the first, terrain changes nothing. The includer defines:
bool is_first_round();

vec3 fetch_share(uint block, uint layer, vec2 place) {
  return is_first_round() ? vec3(1.0) : share_texel(block, layer, place).rgb;
}
#else
vec3 fetch_share(uint block, uint layer, vec2 place) { return share_texel(block, layer, place).rgb; }
#endif

float fetch_base(vec2 place) { return share_texel(0u, kLightLayers, place).a; }

#ifdef AIRLIGHT_COARSE_SLOPES
vec3 fetch_slope_share(vec2 place) { return fetch_share(0u, kLightLayers, place); }
#else
layout(set = 0, binding = 20) uniform sampler2D slopes_lut;

vec3 fetch_slope_share(vec2 place) {
  vec2 size = vec2(textureSize(slopes_lut, 0));
  vec2 cells = size * vec2(0.5, 1.0);
  return textureLod(slopes_lut, (0.5 + place * (cells - 1.0)) / size, 0.0).rgb;
}
#endif

#include "physics/thing_open.glsl"
#include "physics/thing_shares.glsl"

#endif
