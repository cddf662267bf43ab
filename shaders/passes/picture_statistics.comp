#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Statistics of the picture's rows, one workgroup a row.
#define real float
#include "shared/statistics.h"
#include "post/luminance.glsl"

// As many lanes as fill a GPU. On a processor each step of the sum below costs much, so its host computes the
// statistics.
const uint kLanes = 256u;
layout(local_size_x = 256) in;
layout(constant_id = 0) const uint kSigned = 0u;  // 1: a colour may have negative channels
layout(scalar, set = 0, binding = 0) readonly buffer Picture { vec4 values[]; } picture;
layout(scalar, set = 0, binding = 1) writeonly buffer Rows { RowStatistics values[]; } rows_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float brightest;
};

shared RowStatistics partial[kLanes];

bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

#include "post/row_statistics.glsl"

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint y = gl_WorkGroupID.y;
  RowStatistics s = empty_statistics(width);
  for (uint x = lane; x < width; x += kLanes) {
    vec4 value = picture.values[y * width + x];
    s = with_texel(s, value.xyz, value.w, x, brightest, kSigned != 0u);
  }
  partial[lane] = s;
  for (uint others = kLanes / 2u; others > 0u; others /= 2u) {
    barrier();
    if (lane < others) {
      s = sum_of(s, partial[lane + others]);
      partial[lane] = s;
    }
  }
  if (lane == 0u) {
    rows_out.values[y] = s;
  }
}
