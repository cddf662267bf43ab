#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Statistics of the picture's rows, one workgroup a row.
#define real float
#include "shared/statistics.h"
#include "post/luminance.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kSigned = 0u;  // 1: a colour may have negative channels
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(scalar, set = 0, binding = 1) writeonly buffer Rows { RowStatistics values[]; } rows_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float brightest;
};

shared RowStatistics partial[64];

bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

#include "post/row_statistics.glsl"

RowStatistics sum_of(RowStatistics a, RowStatistics b) {
  a.weight += b.weight;
  a.log_luminance_sum += b.log_luminance_sum;
  a.max_luminance = max(a.max_luminance, b.max_luminance);
  a.not_finite += b.not_finite;
  a.negative += b.negative;
  a.outside += b.outside;
  a.first_bad = min(a.first_bad, b.first_bad);
  return a;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint y = gl_WorkGroupID.y;
  RowStatistics s = empty_statistics(width);
  for (uint x = lane; x < width; x += 64u) {
    vec4 value = picture.values[y * width + x];
    s = with_texel(s, value.xyz, value.w, x, brightest, kSigned != 0u);
  }
  partial[lane] = s;
  barrier();
  if (lane == 0u) {
    for (uint i = 1u; i < 64u; i++) {
      s = sum_of(s, partial[i]);
    }
    rows_out.values[y] = s;
  }
}
