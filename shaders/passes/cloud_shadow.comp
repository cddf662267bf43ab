#version 460
#extension GL_GOOGLE_include_directive : require
// Optical depth of a cloud toward the sun: one thread a ray of the sun, which it follows down from the cloud's top.
// Column and row are where the ray enters the top: the grid leans as the sun's rays do. Slices are the layers' edges.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image3D shadow_out;
layout(push_constant, scalar) uniform Push { uint parts; };  // of a layer

void main() {
  CloudData c = cloud();
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x > c.fine_x || at.y > c.fine_y) {
    return;
  }
  float height = c.top - c.base;
  vec2 lean = vec2(c.sunward_east * height / c.width, c.sunward_north * height / c.depth);
  float way = length(vec3(c.sunward_east, c.sunward_north, 1.0)) * height;
  uint steps = parts * c.fine_z;
  float depth = 0.0;
  imageStore(shadow_out, ivec3(at, c.fine_z), vec4(0.0));
  for (uint i = 0u; i < steps; i++) {
    float down = (float(i) + 0.5) / float(steps);
    vec2 place = vec2(at) / vec2(c.fine_x, c.fine_y) - lean * down;
    depth += density_at(vec3(place, 1.0 - down)) * way / float(steps);
    if ((i + 1u) % parts == 0u) {
      imageStore(shadow_out, ivec3(at, c.fine_z - 1u - i / parts), vec4(depth));
    }
  }
}
