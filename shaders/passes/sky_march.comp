#version 460
#extension GL_GOOGLE_include_directive : require
// The view march on the transmittance and multiple-scattering tables, one pixel a thread.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "shared/march_pixels.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
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
  ViewRay view = marched_ray(pixel);
  Ray ray = air_ray(view.direction);
  Upsampled from = upsampled(pixel, width, view.direction, ray.at_ground);
  // The march takes no step on a ray of no length.
  ray.length_ = from.holds ? -1.0 : ray.length_;
  PathRadiance path =
      march_at(scene.planet, scene.sun, ray, steps, kStepDistribution, place_in_step(pixel), scene.multiple_scattering_scale);
  write_marched(pixel, width, view, ray.at_ground, from, path);
}
