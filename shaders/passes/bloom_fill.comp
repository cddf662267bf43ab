#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Rows of the bloom's grid from their finished sums.

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 0) readonly buffer Sums { vec4 values[]; } sums;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D base_out;
layout(push_constant, scalar) uniform Push {
  uvec2 picture_size;
  uint first_grid_row;
  uint grid_rows;
};
#include "post/bloom_grid.glsl"

void main() {
  uvec2 grid_size = uvec2(imageSize(base_out));
  uvec2 place = gl_GlobalInvocationID.xy;
  if (place.x >= grid_size.x || place.y >= grid_rows) {
    return;
  }
  vec4 mean = grid_mean(sums.values[place.y * grid_size.x + place.x].xyz, grid_scale(picture_size, grid_size));
  imageStore(base_out, ivec2(place.x, first_grid_row + place.y), mean);
}
