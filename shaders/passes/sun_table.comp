#version 460
#extension GL_GOOGLE_include_directive : require
// Mean extinction toward the top of the atmosphere over (zenith cosine, row of altitude), for air cut into shells.
#include "shared/device.glsl"
#include "shared/shell_rows.glsl"

real shell_altitude(uint k) { return scene.shell_altitudes[k]; }

#include "physics/shells.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D sun_table_out;

void main() {
  ivec2 size = imageSize(sun_table_out);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  real h = shell_altitude(uint(texel.y));
  real mu = sun_table_mu(scene.planet, h, real(texel.x) / real(size.x - 1));
  imageStore(sun_table_out, texel, vec4(mean_extinction_to_top(scene.planet, h, mu), 1.0));
}
