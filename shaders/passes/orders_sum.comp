#version 460
#extension GL_GOOGLE_include_directive : require
// All orders: the sums plus a geometric tail from the last two orders, in log form.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/tables.h"
#include "shared/moment_shape.glsl"
#include "physics/order_tail.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 3) uniform sampler2D last_order;
layout(set = 0, binding = 7) uniform sampler2D order_before;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D moments_out;
layout(scalar, set = 0, binding = 6) readonly buffer Sums { vec4 values[]; } sums;

vec3 with_tail(uint k, uvec2 node, uint stride) {
  uint block = k == moment_count() ? moment_count() : 0u;
  ivec2 at = ivec2(block * kMomentColumns + node.x, node.y);
  vec3 last = exp(texelFetch(last_order, at, 0).rgb);
  vec3 factor = tail_factor(last, exp(texelFetch(order_before, at, 0).rgb), kShellRows > 0u ? 0.99 : 0.9);
  vec3 mine = texelFetch(last_order, ivec2(k * kMomentColumns + node.x, node.y), 0).rgb;
  return sums.values[node.y * stride + k * kMomentColumns + node.x].rgb + moment_of_code(k, mine, last) * factor;
}

void main() {
  uint stride = (moment_count() + 1u) * kMomentColumns;
  uvec2 texel = gl_GlobalInvocationID.xy;
  if (texel.x >= stride || texel.y >= kMomentRows) {
    return;
  }
  uint k = texel.x / kMomentColumns;
  uvec2 node = uvec2(texel.x % kMomentColumns, texel.y);
  vec3 value = with_tail(k, node, stride);
  vec3 isotropic = max(with_tail(0u, node, stride), vec3(1e-30));
  imageStore(moments_out, ivec2(texel), vec4(moment_code(k, value, isotropic), 1.0));
}
