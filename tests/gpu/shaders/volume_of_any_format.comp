#version 460
// Each texel its coordinates, in an image of whatever format.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(set = 0, binding = 0) writeonly uniform image3D volume_out;

void main() {
  const ivec3 at = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(at, imageSize(volume_out)))) return;
  imageStore(volume_out, at, vec4(at, 1.0));
}
