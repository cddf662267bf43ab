#version 460
#extension GL_GOOGLE_include_directive : require
// A cloud's phase function behind its own forward peak as an image (physics/cloud_light.glsl): angles x depths.
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 1) readonly buffer Phase { vec3 values[]; } phase;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D phase_out;
layout(push_constant, scalar) uniform Push { uvec2 size; };

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= size.x || at.y >= size.y) {
    return;
  }
  imageStore(phase_out, ivec2(at), vec4(phase.values[at.y * size.x + at.x], 0.0));
}
