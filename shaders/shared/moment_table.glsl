// The table of moments as a sampler. With AIRLIGHT_HALF_RATIOS the ratios come from its copy in halves.
#include "shared/moment_shape.glsl"

layout(set = 0, binding = 2) uniform sampler2D moments_lut;
#ifdef AIRLIGHT_HALF_RATIOS
layout(set = 0, binding = 3) uniform sampler2D moment_ratios_lut;
#endif

vec3 fetch_moment(uint k, float x, float y) {
  uint blocks = moment_count() + 1u;
  float u = (float(k * kMomentColumns) + 0.5 + x * float(kMomentColumns - 1u)) / float(blocks * kMomentColumns);
  vec2 at = vec2(u, texel_from_unit(y, float(kMomentRows)));
#ifdef AIRLIGHT_HALF_RATIOS
  if (!is_logarithm(k)) {
    return textureLod(moment_ratios_lut, at, 0.0).rgb;
  }
#endif
  return textureLod(moments_lut, at, 0.0).rgb;
}

real shell_altitude(uint k) { return scene.shell_altitudes[k]; }

#ifdef AIRLIGHT_STOKES
#include "shared/stokes.glsl"
#else
bool stokes() { return false; }
#endif

#include "physics/polarisation.glsl"
#include "physics/stokes.glsl"
#include "physics/moments.glsl"

#ifndef AIRLIGHT_SUN_SHARE
real sun_share(Ray ray, real t, real width) { return 1.0; }
vec3 diffuse_share(Ray ray, real t) { return vec3(1.0); }
#endif
