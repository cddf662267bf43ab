#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 32) in;
layout(set = 0, binding = 0) uniform sampler2D picture_lut;
layout(scalar, set = 0, binding = 1) readonly buffer Points {
  vec2 values[];
} points;
layout(scalar, set = 0, binding = 2) writeonly buffer Samples {
  vec4 values[];
} samples;

void main() {
  const uint at = gl_GlobalInvocationID.x;
  if (at < points.values.length()) samples.values[at] = textureLod(picture_lut, points.values[at], 0.0);
}
