#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud's cells hold as an image, extinction, gap or noise, and how far inside the cloud they lie; the grid
// repeats itself, and so does its first texel.
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 1) readonly buffer Extinction { float values[]; } extinction;
layout(scalar, set = 0, binding = 3) readonly buffer Inside { float values[]; } inside;
layout(set = 0, binding = 2) uniform writeonly image3D density_out;
layout(push_constant, scalar) uniform Push { uvec3 size; };

void main() {
  uvec3 at = gl_GlobalInvocationID;
  if (at.x > size.x || at.y > size.y || at.z >= size.z) {
    return;
  }
  // Texel 0 is the cell before the first. A grid that stands alone has empty cells all around.
  uvec2 cell = mix(at.xy, size.xy, equal(at.xy, uvec2(0u))) - 1u;
  uint i = (at.z * size.y + cell.y) * size.x + cell.x;
  imageStore(density_out, ivec3(at), vec4(extinction.values[i], inside.values[i], 0.0, 0.0));
}
