#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 32) in;
layout(scalar, set = 0, binding = 0) readonly buffer Source {
  uint values[];
} source;
layout(scalar, set = 0, binding = 1) writeonly buffer Target {
  uint values[];
} target;

void main() {
  const uint at = gl_GlobalInvocationID.x;
  if (at < target.values.length()) target.values[at] = source.values[at];
}
