#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// A thread a number, rows of kinds of loops.
layout(local_size_x = 32) in;
layout(scalar, set = 0, binding = 0) writeonly buffer Turned { uint values[]; } turned_out;
layout(push_constant) uniform Push { uint numbers; } push;
#define FUNCTION
#include "../loops.h"

void main() {
  uint n = gl_GlobalInvocationID.x;
  if (n < push.numbers) {
    for (uint kind = 0u; kind < kKinds; kind++) {
      turned_out.values[kind * push.numbers + n] = turned(kind, n);
    }
  }
}
