#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture from its table of factors with the ground apart; the transmittance by a march of its own.
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_table.glsl"
#include "shared/layer_output.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"

const uint kRestBlocks = kStokes != kStokesNone ? 4u : 2u;
#include "shared/factor_fetch.glsl"
#include "shared/stokes_shown.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

LightLayers layers_along(vec3 direction) {
  FactorPlace at = factor_place(direction);
  LightLayers layers = no_layers();
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = single_at(i, at);
  }
  layers.multiple = fetch_shared(diffuse_block(), at);
  layers.ground = fetch_shared(diffuse_block() + 1u, at);
  layers.transmittance = beam_transmittance(scene_apart_factors(air_ray(direction), steps).air);
  if (stokes()) {
    layers = with_polarised(layers, shown(with_stokes(no_light(), diffuse_block() + 2u, at, direction), direction));
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
