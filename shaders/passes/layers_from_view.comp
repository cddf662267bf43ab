#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture from the sky-view table with its light apart. The transmittance is a march of its own; so are
// the ground's rays where the picture marches them.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "physics/sky_view_mapping.glsl"
#include "shared/layer_output.glsl"
#include "physics/march_layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(constant_id = 11) const uint kSkyViewWidth = 192u;
layout(constant_id = 12) const uint kSkyViewHeight = 108u;
layout(constant_id = 13) const uint kSkyViewSkyRows = 72u;
layout(constant_id = 14) const uint kGroundMarches = 0u;
layout(set = 0, binding = 4) uniform sampler2D layers_view_lut;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

vec2 place_in_block(SkyViewCoordinate c) {
  uint first = c.ground ? kSkyViewSkyRows : 0u;
  uint count = c.ground ? kSkyViewHeight - kSkyViewSkyRows : kSkyViewSkyRows;
  return vec2(texel_from_even(c.chord, float(kSkyViewWidth)),
              texel_in_part(c.height, float(first), float(count), float(kSkyViewHeight)));
}

// Clamped to the block as the sampler clamps the plain table to its edge.
vec3 fetch_block(uint block, vec2 at) {
  float blocks = float(bitCount(kScatteringMedia) + 2u);
  float x = clamp(at.x * float(kSkyViewWidth), 0.5, float(kSkyViewWidth) - 0.5);
  return textureLod(layers_view_lut, vec2((float(block * kSkyViewWidth) + x) / (blocks * float(kSkyViewWidth)), at.y), 0.0)
      .rgb;
}

vec3 single_at(uint i, vec2 at) { return scatters(i) ? fetch_block(single_block(i), at) : vec3(0.0); }

LightLayers layers_from_table(vec3 direction) {
  vec2 at = place_in_block(
      sky_view_coordinate(scene.planet, scene.camera.altitude, direction, scene.sun.direction));
  LightLayers layers;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = single_at(i, at);
  }
  layers.multiple = fetch_block(diffuse_block(), at);
  layers.ground = fetch_block(diffuse_block() + 1u, at);
  return layers;
}

LightLayers layers_along(vec3 direction) {
  Ray ray = air_ray(direction);
  LightLayers layers = layers_from_table(direction);
  if (kGroundMarches != 0u && ray.at_ground) {
    layers = march_layers(scene.planet, scene.sun, ray, steps, kStepDistribution, scene.multiple_scattering_scale);
  } else {
    layers.transmittance = march(scene.planet, scene.sun, ray, steps, kStepDistribution, 0.0).transmittance;
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
