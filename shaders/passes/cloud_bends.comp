#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Second differences of a cloud's optical depth toward the sun beside it: along columns, which repeat themselves, along
// rows likewise, and along the sun's rays.
layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 1) readonly buffer Depths { float values[]; } depths;
layout(constant_id = 0) const uint kBends = 1u;  // 0: the depths alone, of a thin field
layout(set = 0, binding = 2) uniform writeonly image3D bends_out;

float depth_at(ivec3 at, ivec3 last) { return depths.values[(at.z * (last.y + 1) + at.y) * (last.x + 1) + at.x]; }

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  ivec3 last = imageSize(bends_out) - 1;  // as the first in x and y
  if (any(greaterThan(at, last))) {
    return;
  }
  float here = depth_at(at, last);
  vec3 bends = vec3(0.0);
  for (int n = 0; n < 3 * int(kBends); n++) {
    int low = at[n] - 1;
    int high = at[n] + 1;
    if (n < 2) {
      low = low < 0 ? last[n] - 1 : low;
      high = high > last[n] ? 1 : high;
    }
    if (low >= 0 && high <= last[n]) {
      ivec3 before = at;
      ivec3 after = at;
      before[n] = low;
      after[n] = high;
      bends[n] = depth_at(before, last) - 2.0 * here + depth_at(after, last);
    }
  }
  imageStore(bends_out, at, vec4(here, bends));
}
