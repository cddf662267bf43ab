// The transmittance table as a sampler, and the physics that fetches it. Bindings 1 to 3 belong to the tables.

// Sizes are constants, so that the map to texel centres is one multiplication and one addition.
layout(constant_id = 7) const uint kTransmittanceWidth = 256u;
layout(constant_id = 8) const uint kTransmittanceHeight = 64u;
layout(set = 0, binding = 1) uniform sampler2D transmittance_lut;

vec3 fetch_transmittance(float x, float y) {
  vec2 uv = vec2(texel_from_unit(x, float(kTransmittanceWidth)), texel_from_unit(y, float(kTransmittanceHeight)));
  return textureLod(transmittance_lut, uv, 0.0).rgb;
}

#include "physics/transmittance_lut.glsl"

vec3 transmittance_to_top(PlanetData planet, real h, real mu) { return table_transmittance(planet, h, mu); }

#include "physics/sunlight.glsl"
