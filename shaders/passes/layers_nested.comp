#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture by the march with a march to the sun inside, one pixel a thread.
#include "shared/device.glsl"
#include "shared/nested_light.glsl"
#include "physics/sunlight.glsl"
#include "physics/march.glsl"
#include "shared/layer_output.glsl"
#include "physics/march_layers.glsl"

LightLayers layers_along(vec3 direction) {
  return march_layers(scene.planet, scene.sun, air_ray(direction), steps, kStepDistribution, 0.0);
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
