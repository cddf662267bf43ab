#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The finished chain at the picture's own pixels.
#include "post/bloom.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D chain;
layout(scalar, set = 0, binding = 1) writeonly buffer Bloom { vec4 values[]; } bloom_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  vec2 uv = (vec2(pixel) + 0.5) / vec2(width, height);
  bloom_out.values[pixel.y * width + pixel.x] = vec4(sample_chain(chain, uv), 1.0);
}
