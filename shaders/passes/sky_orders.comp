#version 460
#extension GL_GOOGLE_include_directive : require
// The view march on the table of moments, one pixel a thread, for small pictures, listed directions and views from
// space: a table of view directions would not pay or would not hold.
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/stokes_march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

struct Seen {
  Stokes light;
  vec3 transmittance;
};

Seen seen_along(vec3 direction) {
  Ray ray = air_ray(ray_direction(direction));
  SkyFactors factors = scene_sky_factors(ray, steps);
  Seen seen;
  seen.light = shown_along(factors, seen_cosine(scene.sun, ray.mu, ray.nu), direction);
  seen.transmittance = beam_transmittance(factors);
  return seen;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  Stokes light = no_light();
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    Seen seen = seen_along(one.direction);
    light = with_share(light, seen.light, one.share);
    transmittance += one.share * seen.transmittance;
  }
  write_light(pixel, view.inside, times(light, scene.sun.irradiance), transmittance);
}
