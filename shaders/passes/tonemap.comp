#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Exposure, tone curve, sRGB encoding.
#define real float
#include "shared/tables.h"
#include "shared/tone_pixel.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float exposure;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  uint index = pixel.y * width + pixel.x;
  write_tone(index, picture.values[index].rgb * exposure);
}
