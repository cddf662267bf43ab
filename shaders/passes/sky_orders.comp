#version 460
#extension GL_GOOGLE_include_directive : require
// The view march on the table of moments, one pixel a thread: for small pictures, listed directions and views from
// space, where a table of view directions does not pay or does not hold.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"

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
  Ray ray = air_ray(view.direction);
  SkyFactors factors = scene_sky_factors(ray, steps);
  write_radiance(pixel, view.inside, phased(factors, phases(ray.nu)) * scene.sun.irradiance, beam_transmittance(factors));
}
