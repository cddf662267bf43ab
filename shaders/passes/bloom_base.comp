#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The bloom's grid from the whole picture.

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D base_out;
layout(push_constant, scalar) uniform Push { uvec2 picture_size; };
#include "post/bloom_grid.glsl"
#include "post/bloom_sum.glsl"

void main() {
  uvec2 grid_size = uvec2(imageSize(base_out));
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (texel.x >= grid_size.x || texel.y >= grid_size.y) {
    return;
  }
  vec2 scale = grid_scale(picture_size, grid_size);
  vec3 sum = grid_sum(vec3(0.0), texel, scale, picture_size.x, 0u, picture_size.y);
  imageStore(base_out, ivec2(texel), grid_mean(sum, scale));
}
