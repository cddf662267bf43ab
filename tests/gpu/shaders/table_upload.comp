#version 460
#extension GL_EXT_scalar_block_layout : require
// A table made on the host, as an image that passes can sample.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) writeonly uniform image2D table_out;
layout(scalar, set = 0, binding = 1) readonly buffer Texels {
  vec4 values[];
} texels;

void main() {
  const ivec2 size = imageSize(table_out);
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  imageStore(table_out, at, texels.values[at.y * size.x + at.x]);
}
