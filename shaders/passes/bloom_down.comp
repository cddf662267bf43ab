#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Halves a level with 13 taps [J14]. The first level keeps what exceeds the threshold, tap by tap, and weighs each box
// by 1/(1 + luminance) so that one bright pixel does not flicker over the picture [K13].
#define real float
#include "shared/tables.h"
#include "post/tone.glsl"
#include "post/bloom.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const uint kFirst = 0u;
layout(set = 0, binding = 0) uniform sampler2D source;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D level_out;
layout(push_constant, scalar) uniform Push {
  vec2 tap;         // distance of neighbouring taps, in texture coordinates of the source
  float threshold;  // on exposed luminance
  float exposure;
};

vec3 tap_at(vec2 uv, float x, float y) {
  vec3 c = sample_chain(source, uv + vec2(x, y) * tap);
  if (kFirst == 0u) {
    return c;
  }
  float luminance = luminance_bt709(c) * exposure;
  return c * (max(luminance - threshold, 0.0) / max(luminance, 1e-4));
}

float box_weight(vec3 c) { return kFirst == 0u ? 1.0 : 1.0 / (1.0 + luminance_bt709(c) * exposure); }

void main() {
  ivec2 size = imageSize(level_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  vec2 uv = (vec2(texel) + 0.5) / vec2(size);
  vec3 grid[9];
  for (uint i = 0u; i < 9u; i++) {
    grid[i] = tap_at(uv, float(i % 3u) * 2.0 - 2.0, float(i / 3u) * 2.0 - 2.0);
  }
  vec3 middle = 0.25 * (tap_at(uv, -1.0, -1.0) + tap_at(uv, 1.0, -1.0) + tap_at(uv, -1.0, 1.0) + tap_at(uv, 1.0, 1.0));
  float weight = 0.5 * box_weight(middle);
  vec3 sum = middle * weight;
  for (uint i = 0u; i < 4u; i++) {
    uint corner = i % 2u + 3u * (i / 2u);
    vec3 box = 0.25 * (grid[corner] + grid[corner + 1u] + grid[corner + 3u] + grid[corner + 4u]);
    float w = 0.125 * box_weight(box);
    sum += box * w;
    weight += w;
  }
  imageStore(level_out, texel, vec4(sum / weight, 1.0));
}
