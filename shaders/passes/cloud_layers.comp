#version 460
#extension GL_GOOGLE_include_directive : require
// Puts a cloud into the layers of a clear sky (shared/layer_output.glsl): those are seen through it, and behind them
// stand the cloud's own five planes: its light, the share of what is behind that it hides, and that share times the
// distance of what hides it.
#define AIRLIGHT_CLOUD_APART
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/picture_ray.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/sky_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/factor_place.glsl"
#include "shared/aerial_volume.glsl"
#include "shared/volume_fetch.glsl"

layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float step;       // km, the shortest
  float step_rise;  // of the step over the distance
};
#include "shared/cloud_pixels.glsl"

layout(constant_id = 56) const uint kAirLayers = 2u;     // of light of the air: single of each medium, multiple
layout(constant_id = 57) const uint kStokesLayers = 0u;  // 2: Q and U are there
layout(scalar, set = 0, binding = 9) buffer Layers { float values[]; } layers_out;
layout(scalar, set = 0, binding = 31) buffer Through { float values[]; } through_out;

// After the air's layers and the ground's.
uint beam_layer() { return kAirLayers + 1u; }
uint cloud_layer() { return kAirLayers + 2u + kStokesLayers; }
uint alpha_plane() { return 3u * (cloud_layer() + 1u); }

uint place_of(uint plane) { return plane * width * height + gl_GlobalInvocationID.y * width + gl_GlobalInvocationID.x; }

vec3 layer(uint i) {
  return vec3(layers_out.values[place_of(3u * i)], layers_out.values[place_of(3u * i + 1u)],
              layers_out.values[place_of(3u * i + 2u)]);
}

void put_layer(uint i, vec3 value) {
  layers_out.values[place_of(3u * i)] = value.x;
  layers_out.values[place_of(3u * i + 1u)] = value.y;
  layers_out.values[place_of(3u * i + 2u)] = value.z;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  vec3 air = vec3(0.0);
  for (uint i = 0u; i < kAirLayers; i++) {
    air += layer(i);
  }
  vec3 ground = layer(kAirLayers);
  bool first = kFurther == 0u;
  vec3 farther = first ? vec3(0.0) : layer(cloud_layer());
  PastCloud past = past_cloud(ray_through_clouds(pixel, view.direction), air_ray(view.direction).length_);
  vec3 light = light_past(past, air + ground + farther);
  float through = view.inside ? past.through : 1.0;
  float beam = pow(through, 1.0 / cloud().scale);
  through_out.values[place_of(0u)] = first ? beam : through_out.values[place_of(0u)] * beam;
  vec3 lit = max(ground * through + past.ground, vec3(0.0));
  vec3 left = max(light - past.cloud - lit - farther * through, vec3(0.0)) / max(air, vec3(1e-20));
  float hidden = first ? 0.0 : layers_out.values[place_of(alpha_plane())];
  float reach = first ? 0.0 : layers_out.values[place_of(alpha_plane() + 1u)];
  layers_out.values[place_of(alpha_plane())] = 1.0 - (1.0 - hidden) * through;
  layers_out.values[place_of(alpha_plane() + 1u)] = reach * through + past.reach * (1.0 - through);
  put_layer(cloud_layer(), view.inside ? farther * through + past.cloud : vec3(0.0));
  if (!view.inside) {
    return;
  }
  for (uint i = 0u; i < kAirLayers; i++) {
    put_layer(i, layer(i) * left);
  }
  put_layer(kAirLayers, lit);
  put_layer(beam_layer(), layer(beam_layer()) * beam);
  // Light of clouds is not polarised: Q and U are the air's.
  for (uint i = 0u; i < kStokesLayers; i++) {
    put_layer(beam_layer() + 1u + i, layer(beam_layer() + 1u + i) * left);
  }
}
