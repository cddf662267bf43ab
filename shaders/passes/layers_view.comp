#version 460
#extension GL_GOOGLE_include_directive : require
// The sky-view table with its light apart: blocks side by side, one for each medium that scatters, then multiple
// scattering and the ground.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "physics/sky_view_mapping.glsl"
#include "shared/sky_view_ray.glsl"
#include "shared/scattering_media.glsl"
#include "physics/layers.glsl"
#include "physics/march_layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D layers_view_out;
layout(push_constant, scalar) uniform Push {
  uint columns;
  uint steps;
  uint sky_rows;
};

void store(uint block, ivec2 texel, vec3 light) {
  imageStore(layers_view_out, ivec2(int(block * columns) + texel.x, texel.y), vec4(light, 1.0));
}

void store_single(uint i, LightLayers layers, ivec2 texel) {
  if (scatters(i)) {
    store(single_block(i), texel, layers.single[i]);
  }
}

void main() {
  ivec2 size = ivec2(int(columns), imageSize(layers_view_out).y);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  Ray ray = sky_view_texel_ray(texel, size, int(sky_rows));
  LightLayers layers =
      march_layers(scene.planet, scene.sun, ray, steps, kStepDistribution, scene.multiple_scattering_scale);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    store_single(i, layers, texel);
  }
  store(diffuse_block(), texel, layers.multiple);
  store(diffuse_block() + 1u, texel, layers.ground);
}
