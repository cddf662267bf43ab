#version 460
#extension GL_GOOGLE_include_directive : require
// A picture through a polarising filter, of its layers among clouds (shared/layer_output.glsl, cloud_layers.comp).
#include "shared/device.glsl"
#include "shared/stokes.glsl"
bool polarised() { return stokes(); }
#include "physics/polarisation.glsl"
#include "physics/stokes.glsl"
#include "shared/picture_ray.glsl"
#include "shared/stokes_shown.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 56) const uint kAirLayers = 2u;  // cloud_layers.comp
layout(scalar, set = 0, binding = 8) readonly buffer Layers { float values[]; } layers;
layout(scalar, set = 0, binding = 9) writeonly buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

vec3 layer(uint i) {
  uint plane = width * height;
  uint at = 3u * i * plane + gl_GlobalInvocationID.y * width + gl_GlobalInvocationID.x;
  return vec3(layers.values[at], layers.values[at + plane], layers.values[at + 2u * plane]);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  vec3 direction = with_azimuth(view.direction, scene.sun.direction);
  // After the air's light: ground, transmittance, Q, U, the clouds' own light.
  Stokes light;
  light.i = layer(kAirLayers) + layer(kAirLayers + 4u);
  for (uint i = 0u; i < kAirLayers; i++) {
    light.i += layer(i);
  }
  light.q = layer(kAirLayers + 2u);
  light.u = layer(kAirLayers + 3u);
  Axes by_sun = axes_across(direction, scene.sun.direction);
  Axes by_zenith;  // to which Q and U of layers refer
  by_zenith.first = downward_across(direction);
  by_zenith.second = by_sun.second * dot(by_zenith.first, by_sun.first) -
                     by_sun.first * dot(by_zenith.first, by_sun.second);
  light.i += kFiltered * by_axis(light, by_zenith, filter_axis(scene.camera, direction)).q;
  radiance_out.values[pixel.y * scene.tile.width + pixel.x] = view.inside ? vec4(light.i, 1.0) : vec4(0.0);
}
