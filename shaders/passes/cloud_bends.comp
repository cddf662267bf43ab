#version 460
#extension GL_GOOGLE_include_directive : require
// Second differences of a cloud's optical depth toward the sun beside it: along columns, which repeat themselves, along
// rows likewise, and along the sun's rays.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1) uniform sampler3D depths_lut;
layout(set = 0, binding = 2) uniform writeonly image3D bends_out;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  ivec3 last = textureSize(depths_lut, 0) - 1;  // as the first in x and y
  if (any(greaterThan(at, last))) {
    return;
  }
  float here = texelFetch(depths_lut, at, 0).r;
  vec3 bends = vec3(0.0);
  for (int n = 0; n < 3; n++) {
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
      bends[n] = texelFetch(depths_lut, before, 0).r - 2.0 * here + texelFetch(depths_lut, after, 0).r;
    }
  }
  imageStore(bends_out, at, vec4(here, bends));
}
