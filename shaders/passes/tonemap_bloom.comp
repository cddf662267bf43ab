#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Exposure, bloom, tone curve, sRGB encoding. The chain is sampled here: bloom at the picture's size, written by one
// pass and read by the next, would be 32 bytes a pixel.
#define real float
#include "shared/tables.h"
#include "shared/tone_pixel.glsl"
#include "post/bloom.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(set = 0, binding = 2) uniform sampler2D chain;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint rows;
  float exposure;
  float bloom_intensity;
  uint first_row;  // row of the whole picture that the first of `rows` is
  uint height;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= rows) {
    return;
  }
  uint index = pixel.y * width + pixel.x;
  vec2 uv = (vec2(pixel.x, first_row + pixel.y) + 0.5) / vec2(width, height);
  write_tone(index, (picture.values[index].rgb + sample_chain(chain, uv) * bloom_intensity) * exposure);
}
