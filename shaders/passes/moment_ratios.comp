#version 460
// The table of moments in halves, which a GPU's samplers filter several times as fast. Halves suffice for the ratios,
// but not for the logarithms in the first and the last block, where a rounding scales the light itself.

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D moments;
layout(set = 0, binding = 1) uniform writeonly image2D ratios_out;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x < imageSize(ratios_out).x && texel.y < imageSize(ratios_out).y) {
    imageStore(ratios_out, texel, texelFetch(moments, texel, 0));
  }
}
