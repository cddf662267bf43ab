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
  PixelRays rays = marched_rays(pixel, view);
  bool at_ground = air_ray(view.direction).at_ground;
  Upsampled from = upsampled(pixel, width, view.direction, at_ground);
  from.holds = from.holds && rays.count == 1u;
  PathRadiance mean;
  mean.radiance = vec3(0.0);
  mean.transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    Ray ray = air_ray(one.direction);
    // The march takes no step on a ray of negative length.
    ray.length_ = from.holds ? -1.0 : ray.length_;
    PathRadiance path =
        march_at(scene.planet, scene.sun, ray, steps, kStepDistribution, place_in_step(pixel), scene.multiple_scattering_scale);
    mean.radiance += one.share * path.radiance;
    mean.transmittance += one.share * path.transmittance;
  }
  write_marched(pixel, width, view, at_ground, from, mean);
}
