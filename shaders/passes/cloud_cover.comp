#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// Adds what stands behind a cloud to a picture: the sun's disc, stars and the night sky, by what the cloud leaves of a
// beam.

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 0) readonly buffer Behind { vec4 values[]; } behind;
layout(scalar, set = 0, binding = 1) readonly buffer Through { float values[]; } through;
layout(scalar, set = 0, binding = 2) buffer Radiance { vec4 values[]; } radiance_out;
layout(push_constant, scalar) uniform Push { uint width; uint height; };

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  uint i = pixel.y * width + pixel.x;
  radiance_out.values[i].rgb += behind.values[i].rgb * through.values[i];
}
