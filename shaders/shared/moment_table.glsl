// The table of moments as a sampler.
#include "shared/moment_shape.glsl"

layout(set = 0, binding = 2) uniform sampler2D moments_lut;

vec3 fetch_moment(uint k, float x, float y) {
  uint blocks = (kMomentDegree + 1u) * (kMomentDegree + 2u) / 2u + 1u;
  float u = (float(k * kMomentColumns) + 0.5 + x * float(kMomentColumns - 1u)) / float(blocks * kMomentColumns);
  return textureLod(moments_lut, vec2(u, texel_from_unit(y, float(kMomentRows))), 0.0).rgb;
}

real shell_altitude(uint k) { return scene.shell_altitudes[k]; }

#include "physics/moments.glsl"

#ifndef AIRLIGHT_SUN_SHARE
real sun_share(Ray ray, real t, real width) { return 1.0; }
#endif
