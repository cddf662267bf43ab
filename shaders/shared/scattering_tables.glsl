// The multiple-scattering table as a sampler.

layout(constant_id = 9) const uint kScatteringWidth = 32u;
layout(constant_id = 10) const uint kScatteringHeight = 32u;
layout(set = 0, binding = 2) uniform sampler2D multiple_scattering_lut;

vec3 fetch_multiple_scattering(float x, float y) {
  vec2 uv = vec2(texel_from_unit(x, float(kScatteringWidth)), texel_from_unit(y, float(kScatteringHeight)));
  return textureLod(multiple_scattering_lut, uv, 0.0).rgb;
}
