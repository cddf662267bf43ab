#version 460
#extension GL_GOOGLE_include_directive : require
// The sun's glare at each pixel of the picture, before its intensity.
#include "shared/glare_pixel.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 9) writeonly buffer Bloom { vec4 values[]; } bloom_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint points;
  float pixel_blur;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  bloom_out.values[pixel.y * width + pixel.x] = vec4(glare_at(pixel, points, pixel_blur), 1.0);
}
