#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture by the view march on tables, one pixel a thread.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "shared/layer_output.glsl"
#include "physics/march_layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

LightLayers layers_along(vec3 direction) {
  return march_layers(scene.planet, scene.sun, air_ray(direction), steps, kStepDistribution,
                      scene.multiple_scattering_scale);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  LightLayers sum = empty_layers();
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    sum = with_share(sum, layers_along(one.direction), one.share);
  }
  write_layers(pixel, uvec2(width, height), view.inside, sum);
}
