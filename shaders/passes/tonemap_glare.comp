#version 460
#extension GL_GOOGLE_include_directive : require
// Exposure, the sun's glare, tone curve, sRGB encoding.
#include "shared/glare_pixel.glsl"
#include "shared/tone_pixel.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float exposure;
  float intensity;
  uint points;
  float pixel_blur;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  uint index = pixel.y * width + pixel.x;
  write_tone(index, (picture.values[index].rgb + glare_at(pixel, points, pixel_blur) * intensity) * exposure);
}
