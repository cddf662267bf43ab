// The transmittance table as a sampler, and the physics that fetches it. Bindings 1 to 3 belong to the tables.

// Sizes are constants, so that the map to texel centres is one multiplication and one addition.
layout(constant_id = 7) const uint kTransmittanceWidth = 256u;
layout(constant_id = 8) const uint kTransmittanceHeight = 64u;
layout(set = 0, binding = 1) uniform sampler2D transmittance_lut;

// Where the air bends light the table is two, one below the other: of sunlight, and of seen directions.
vec4 fetch_half(float x, float y, float half_) {
  vec2 uv = vec2(texel_from_unit(x, float(kTransmittanceWidth)), texel_from_unit(y, float(kTransmittanceHeight)));
  if (bends_light()) {
    uv.y = 0.5 * (uv.y + half_);
  }
  return textureLod(transmittance_lut, uv, 0.0);
}

vec3 fetch_transmittance(float x, float y) { return fetch_half(x, y, 0.0).rgb; }

#include "physics/transmittance_lut.glsl"

vec3 transmittance_to_top(PlanetData planet, real h, real mu) { return table_transmittance(planet, h, mu); }

#ifdef AIRLIGHT_EXACT_BENDING
// In 32 bits: the weights of a sampler may have 8, which shows at the edge of a disc.
real bending_along(PlanetData planet, real h, real mu) {
  TransmittanceCoordinate c = transmittance_coordinate(planet, h, mu);
  ivec2 last = ivec2(kTransmittanceWidth, kTransmittanceHeight) - 1;
  vec2 at = vec2(c.x, c.y) * vec2(last);
  ivec2 low = min(ivec2(at), last - 1);
  vec2 part = at - vec2(low);
  low.y += int(kTransmittanceHeight);
  real below = mix(texelFetch(transmittance_lut, low, 0).a, texelFetch(transmittance_lut, low + ivec2(1, 0), 0).a, part.x);
  real above = mix(texelFetch(transmittance_lut, low + ivec2(0, 1), 0).a,
                   texelFetch(transmittance_lut, low + ivec2(1, 1), 0).a, part.x);
  return mix(below, above, part.y);
}
#else
real bending_along(PlanetData planet, real h, real mu) {
  TransmittanceCoordinate c = transmittance_coordinate(planet, h, mu);
  return fetch_half(c.x, c.y, 1.0).a;
}
#endif

// Along a direction as it is seen.
vec3 seen_transmittance(PlanetData planet, real h, real mu) {
  TransmittanceCoordinate c = transmittance_coordinate(planet, h, mu);
  return fetch_half(c.x, c.y, bends_light() ? 1.0 : 0.0).rgb;
}

#include "physics/sunlight.glsl"
