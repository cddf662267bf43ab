#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Adds two tables of three wavelengths each to a table in colours, each wavelength by its column of the matrix. Sums
// over wavelengths may be taken of tables as of pictures where the picture is linear in the table.

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D before;
layout(set = 0, binding = 1) uniform sampler2D part_a;
layout(set = 0, binding = 2) uniform sampler2D part_b;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D sum_out;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint first;      // not 0: no table precedes
  vec3 colours[6];  // for the channels of both parts
};

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= int(width) || texel.y >= int(height)) {
    return;
  }
  vec3 a = texelFetch(part_a, texel, 0).rgb;
  vec3 b = texelFetch(part_b, texel, 0).rgb;
  vec3 sum = a.r * colours[0] + a.g * colours[1] + a.b * colours[2] + b.r * colours[3] + b.g * colours[4] +
             b.b * colours[5];
  vec3 so_far = texelFetch(before, texel, 0).rgb;
  imageStore(sum_out, texel, vec4(sum + mix(so_far, vec3(0.0), bvec3(first != 0u)), 1.0));
}
