#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Adds a picture of three wavelengths to a picture in colours, each wavelength by its column of the matrix.

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 0) readonly buffer Part { vec4 values[]; } part;
layout(scalar, set = 0, binding = 1) buffer Picture { vec4 values[]; } picture;
layout(push_constant, scalar) uniform Push {
  uint count;  // number of vec4s
  uint first;  // not 0: the picture holds nothing so far
  vec3 red;    // colours of the part's channels
  vec3 green;
  vec3 blue;
};

void main() {
  uint i = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * 65536u;
  if (gl_GlobalInvocationID.x >= 65536u || i >= count) {
    return;
  }
  vec4 value = part.values[i];
  vec3 colour = value.r * red + value.g * green + value.b * blue;
  vec4 before = vec4(0.0);
  if (first == 0u) {
    before = picture.values[i];
  }
  picture.values[i] = vec4(before.rgb + colour, max(before.a, value.a));
}
