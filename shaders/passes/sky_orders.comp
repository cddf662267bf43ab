#version 460
#extension GL_GOOGLE_include_directive : require
// The view march on the table of moments, one pixel a thread, for small pictures, listed directions and views from
// space: a table of view directions would not pay or would not hold.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/horizon_pixels.glsl"

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
  PixelRays rays = rays_at(pixel, view);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    Ray ray = air_ray(one.direction);
    SkyFactors factors = scene_sky_factors(ray, steps);
    radiance += one.share * phased(factors, phases(seen_cosine(scene.sun, ray.mu, ray.nu)));
    transmittance += one.share * beam_transmittance(factors);
  }
  write_radiance(pixel, view.inside, radiance * scene.sun.irradiance, transmittance);
}
