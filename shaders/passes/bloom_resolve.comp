#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The finished chain at the picture's own pixels, for the rows from `first_row` on.
#include "post/bloom.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D chain;
layout(scalar, set = 0, binding = 1) writeonly buffer Bloom { vec4 values[]; } bloom_out;
layout(push_constant, scalar) uniform Push {
  uvec2 picture_size;
  uint first_row;
  uint rows;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= picture_size.x || pixel.y >= rows) {
    return;
  }
  vec2 uv = (vec2(pixel.x, first_row + pixel.y) + 0.5) / vec2(picture_size);
  bloom_out.values[pixel.y * picture_size.x + pixel.x] = vec4(sample_chain(chain, uv), 1.0);
}
