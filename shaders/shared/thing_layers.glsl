// The layers of a picture of things, the air up to which the includer finds. What mirrors show counts as light of the
// surface.

#include "shared/thing_pass.glsl"

#define Gathered LightLayers

LightLayers nothing_gathered() { return no_layers(); }

LightLayers with_air(LightLayers sum, SkyFactors air, float nu, vec3 through, bool first) {
  Phases p = phases(nu);
  if (!first) {
    sum.ground += through * phased(air, p) * scene.sun.irradiance;
    return sum;
  }
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    sum.single[i] = air.single[i] * p.of[i] * scene.sun.irradiance;
  }
  sum.multiple = air.diffuse * scene.sun.irradiance;
  sum.transmittance = beam_transmittance(air);
#ifdef AIRLIGHT_STOKES
  if (stokes()) {
    sum = with_polarised(sum, times(shown_along(air, nu, looking), scene.sun.irradiance));
  }
#endif
  return sum;
}

LightLayers with_light(LightLayers sum, vec3 light) {
  sum.ground += light;
  return sum;
}

#include "shared/thing_rays.glsl"

ViewRay ray_at(uvec2 pixel, vec2 place) { return camera_ray(pixel, place); }

#define PixelSeen LightLayers

PixelSeen nothing_seen() { return empty_layers(); }

PixelSeen ray_seen(ThingRay one) {
  looking = one.direction;
  return with_share(empty_layers(), gathered_along(ray_direction(looking), one.spread, one.bare, steps), one.share);
}

PixelSeen with_seen(PixelSeen sum, PixelSeen one) { return with_share(sum, one, 1.0); }

void write_seen(bool inside, PixelSeen seen) { write_layers(here, uvec2(width, height), inside, seen); }

#include "shared/thing_pixels.glsl"
