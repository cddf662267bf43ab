#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The bloom's grid from the whole picture.

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D base_out;
layout(push_constant, scalar) uniform Push { uvec2 picture_size; };
#include "post/bloom_grid.glsl"

// What a texel of the grid covers of the picture, summed up.
vec3 grid_sum(uvec2 texel, vec2 scale) {
  vec2 low = vec2(texel) * scale;
  vec2 high = low + scale;
  precise vec3 sum = vec3(0.0);
  for (uint y = uint(low.y); y < min(uint(ceil(high.y)), picture_size.y); y++) {
    float wy = min(float(y + 1u), high.y) - max(float(y), low.y);
    for (uint x = uint(low.x); x < min(uint(ceil(high.x)), picture_size.x); x++) {
      float wx = min(float(x + 1u), high.x) - max(float(x), low.x);
      sum += picture.values[y * picture_size.x + x].rgb * (wx * wy);
    }
  }
  return sum;
}

void main() {
  uvec2 grid_size = uvec2(imageSize(base_out));
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (texel.x >= grid_size.x || texel.y >= grid_size.y) {
    return;
  }
  vec2 scale = grid_scale(picture_size, grid_size);
  imageStore(base_out, ivec2(texel), grid_mean(grid_sum(texel, scale), scale));
}
