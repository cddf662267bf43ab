#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Adds the next coarser level, spread by a 3 x 3 tent, to a level [J14].
#include "post/bloom.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D coarser;
layout(set = 0, binding = 1) uniform sampler2D level;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D sum_out;
layout(push_constant, scalar) uniform Push {
  vec2 tap;  // distance of neighbouring taps, in texture coordinates of the coarser level
};

void main() {
  ivec2 size = imageSize(sum_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  vec2 uv = (vec2(texel) + 0.5) / vec2(size);
  vec3 sum = texelFetch(level, texel, 0).rgb;
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      float weight = float((2 - abs(x)) * (2 - abs(y))) / 16.0;
      sum += sample_chain(coarser, uv + vec2(x, y) * tap) * weight;
    }
  }
  imageStore(sum_out, texel, vec4(sum, 1.0));
}
