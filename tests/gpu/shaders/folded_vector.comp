#version 460
#extension GL_EXT_scalar_block_layout : require
// A vector of constants whose parts fold to a constant that the module declares further down.
layout(local_size_x = 1) in;
layout(constant_id = 0) const uint kColumns = 64u;
layout(constant_id = 1) const uint kRows = 4u;
layout(scalar, set = 0, binding = 0) buffer Report {
  uvec2 last;
  uint other;
} report;

void main() {
  report.last = min(gl_GlobalInvocationID.xy, uvec2(kColumns, kRows + kRows + 1u) - 1u);
  report.other = gl_GlobalInvocationID.x * 63u;
}
