#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Adds a band of the picture's rows to the sums of the bloom's grid, for those rows of the grid that the band touches.

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(scalar, set = 0, binding = 1) buffer Sums { vec4 values[]; } sums_out;
layout(push_constant, scalar) uniform Push {
  uvec2 picture_size;
  uvec2 grid_size;
  uint first_row;       // the band's first row in the picture
  uint end_row;
  uint first_grid_row;  // first row of the grid in the sums
  uint grid_rows;
};
#include "post/bloom_grid.glsl"
#include "post/bloom_sum.glsl"

void main() {
  uvec2 place = gl_GlobalInvocationID.xy;
  if (place.x >= grid_size.x || place.y >= grid_rows) {
    return;
  }
  uint index = place.y * grid_size.x + place.x;
  uvec2 texel = uvec2(place.x, first_grid_row + place.y);
  vec2 scale = grid_scale(picture_size, grid_size);
  vec3 sum = grid_sum(sums_out.values[index].xyz, texel, scale, picture_size.x, first_row, end_row);
  sums_out.values[index] = vec4(sum, 0.0);
}
