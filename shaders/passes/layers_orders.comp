#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture by the view march on the table of moments, one pixel a thread.
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/layer_output.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/stokes_march.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

LightLayers layers_along(vec3 direction) {
  Ray ray = air_ray(ray_direction(direction));
  ApartFactors factors = scene_apart_factors(ray, steps);
  Phases p = phases(seen_cosine(scene.sun, ray.mu, ray.nu));
  LightLayers layers = no_layers();
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = factors.air.single[i] * p.of[i] * scene.sun.irradiance;
  }
  layers.multiple = factors.air.diffuse * scene.sun.irradiance;
  layers.ground = factors.ground * scene.sun.irradiance;
  layers.transmittance = beam_transmittance(factors.air);
  if (stokes()) {
    layers = with_polarised(layers, times(shown_along(factors.air, ray.nu, direction), scene.sun.irradiance));
  }
  return layers;
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
