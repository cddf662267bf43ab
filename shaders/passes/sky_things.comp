#version 460
#extension GL_GOOGLE_include_directive : require
// Things, the ground, the sky and the air before and behind them, with the things' shadows on each other and in the
// air: surfaces first, then the view march on the table of moments up to them, along each pixel's ray and along the
// rays that mirrors reflect. A pixel with an edge, a shadow's edge or a mirror is the mean over rays through all of it.
#define AIRLIGHT_SUN_SHARE
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/thing_march.glsl"
#include "shared/stokes_march.glsl"

vec3 looking;  // direction of the first part of the ray at hand

struct Gathered {
  Stokes light;
  vec3 transmittance;  // up to the first thing
};

Gathered nothing_gathered() { return Gathered(no_light(), vec3(1.0)); }

Gathered with_air(Gathered sum, SkyFactors air, float nu, vec3 through, bool first) {
  if (stokes() && first) {
    sum.light = times(shown_along(air, nu, looking), scene.sun.irradiance);
  } else {
    sum.light.i += through * phased(air, phases(nu)) * scene.sun.irradiance;
  }
  sum.transmittance = first ? beam_transmittance(air) : sum.transmittance;
  return sum;
}

Gathered with_light(Gathered sum, vec3 light) {
  sum.light.i += light;
  return sum;
}

#include "shared/thing_rays.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  ThingPixel rays = thing_pixel(pixel, view);
  Stokes light = no_light();
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = ray_of_thing_pixel(pixel, view, rays, i);
    looking = one.direction;
    Gathered seen = gathered_along(ray_direction(looking), rays.spread, steps);
    light = with_share(light, seen.light, one.share);
    transmittance += one.share * seen.transmittance;
  }
  write_light(pixel, view.inside, light, transmittance);
}
