#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Exposure, bloom, tone curve, sRGB encoding: four 16-bit channels a pixel, ready for a PNG.
#define real float
#include "shared/tables.h"
#include "post/tone.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kCurve = 0u;
layout(constant_id = 1) const uint kBloom = 0u;  // 0: the bloom buffer is not read
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(scalar, set = 0, binding = 1) readonly buffer Bloom { vec4 values[]; } bloom;
layout(scalar, set = 0, binding = 2) writeonly buffer Encoded { uvec2 values[]; } encoded_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float exposure;
  float bloom_intensity;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  uint index = pixel.y * width + pixel.x;
  vec4 value = picture.values[index];
  vec3 c = value.rgb;
  if (kBloom != 0u) {
    c += bloom.values[index].rgb * bloom_intensity;
  }
  vec3 display = tone_curve(kCurve, c * exposure);
  vec3 srgb = vec3(srgb_encoded(display.x), srgb_encoded(display.y), srgb_encoded(display.z));
  encoded_out.values[index] = uvec2(packUnorm2x16(srgb.xy), packUnorm2x16(vec2(srgb.z, clamp(value.w, 0.0, 1.0))));
}
