// The sky's irradiance on the ground as a sampler. kGroundReflects = 0: the ground is black and nothing is fetched.

layout(constant_id = 5) const uint kGroundReflects = 0u;
layout(set = 0, binding = 3) uniform sampler2D ground_irradiance_lut;

bool ground_reflects() { return kGroundReflects != 0u; }

vec3 fetch_ground_irradiance(float x) {
  return textureLod(ground_irradiance_lut, vec2(texel_from_unit(x, float(kGroundIrradianceSize)), 0.5), 0.0).rgb;
}
