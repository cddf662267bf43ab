#version 460
// Each texel gets its own number plus the pushed one.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) writeonly uniform image2D ramp_out;
layout(push_constant) uniform Push {
  uint base;
} push;

void main() {
  const ivec2 size = imageSize(ramp_out);
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  imageStore(ramp_out, at, vec4(float(push.base) + float(at.y * size.x + at.x), at.x, at.y, 1.0));
}
