#version 460
#extension GL_EXT_scalar_block_layout : require
// Adds the pushed number to every number.
layout(local_size_x = 32) in;
layout(scalar, set = 0, binding = 0) buffer Numbers {
  uint values[];
} numbers;
layout(push_constant) uniform Push {
  uint amount;
} push;

void main() {
  const uint at = gl_GlobalInvocationID.x;
  if (at < numbers.values.length()) numbers.values[at] += push.amount;
}
