#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Turns a picture of three wavelengths into colours, each wavelength by its column of the matrix, and adds it to a
// picture in colours, or leaves it where it was.

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 0) readonly buffer Part { vec4 values[]; } part;
layout(scalar, set = 0, binding = 1) buffer Picture { vec4 values[]; } picture;
layout(push_constant, scalar) uniform Push {
  uint count;  // number of vec4s
  uint way;    // kAdds, ...
  vec3 red;    // colours of the part's channels
  vec3 green;
  vec3 blue;
};

#include "shared/colours.glsl"

const uint kAdds = 0u;
const uint kFirst = 1u;    // the picture holds nothing so far
const uint kInPlace = 2u;  // the picture is the part

void main() {
  uint i = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * 65536u;
  if (gl_GlobalInvocationID.x >= 65536u || i >= count) {
    return;
  }
  vec4 value = vec4(0.0);
  vec4 before = vec4(0.0);
  if (way == kInPlace) {
    value = picture.values[i];
  } else {
    value = part.values[i];
  }
  if (way == kAdds) {
    before = picture.values[i];
  }
  picture.values[i] = vec4(before.rgb + in_colours(value.rgb), max(before.a, value.a));
}
