// One workgroup a row: counts what is not finite or negative, and sums what the exposure's meter needs. A texel weighs as
// the root of its luminance does: what is black weighs nothing, a ground 600 times darker than the sky next to nothing,
// and the mean is as bright for a picture k times as bright. What exceeds `brightest` counts as being so bright. The
// includer defines: vec4 value_at(uint x, uint y);  alpha 0 leaves a texel out.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/statistics.h"
#include "shared/tables.h"
#include "post/tone.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kSigned = 0u;  // 1: a colour may have negative channels
layout(scalar, set = 0, binding = 1) writeonly buffer Rows { RowStatistics values[]; } rows_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  float brightest;
};

shared RowStatistics partial[64];

bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

RowStatistics empty_statistics() {
  RowStatistics s;
  s.weight = 0.0;
  s.log_luminance_sum = 0.0;
  s.max_luminance = 0.0;
  s.not_finite = 0u;
  s.negative = 0u;
  s.outside = 0u;
  s.first_bad = width;
  return s;
}

void collect(inout RowStatistics s, vec4 value, uint x) {
  bool finite = is_finite(value.x) && is_finite(value.y) && is_finite(value.z);
  bool below = finite && (value.x < 0.0 || value.y < 0.0 || value.z < 0.0);
  float luminance = finite ? luminance_bt709(value.xyz) : 0.0;
  float metered = clamp(luminance, 1e-37, brightest);
  float weight = luminance > 0.0 && value.w > 0.0 ? sqrt(metered) : 0.0;
  s.weight += weight;
  s.log_luminance_sum += weight * log(metered);
  bool negative = kSigned == 0u ? below : luminance < 0.0;
  s.max_luminance = max(s.max_luminance, luminance);
  s.not_finite += finite ? 0u : 1u;
  s.negative += negative ? 1u : 0u;
  s.outside += below && kSigned != 0u ? 1u : 0u;
  s.first_bad = (!finite || negative) ? min(s.first_bad, x) : s.first_bad;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint y = gl_WorkGroupID.y;
  RowStatistics s = empty_statistics();
  for (uint x = lane; x < width; x += 64u) {
    collect(s, value_at(x, y), x);
  }
  partial[lane] = s;
  barrier();
  if (lane == 0u) {
    for (uint i = 1u; i < 64u; i++) {
      s.weight += partial[i].weight;
      s.log_luminance_sum += partial[i].log_luminance_sum;
      s.max_luminance = max(s.max_luminance, partial[i].max_luminance);
      s.not_finite += partial[i].not_finite;
      s.negative += partial[i].negative;
      s.outside += partial[i].outside;
      s.first_bad = min(s.first_bad, partial[i].first_bad);
    }
    rows_out.values[y] = s;
  }
}
