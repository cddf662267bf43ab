#version 460
#extension GL_GOOGLE_include_directive : require
// sun_table.comp for air that bends light: the beam's spreading counts as extinction, along a tenth of the air's height
// at least, since at its top there is none left: neither what rounding leaves of it nor an index above 1 may be spread
// over no length. Below it, the table of seen directions, of the same size.
#include "shared/device.glsl"
#include "shared/shell_rows.glsl"
#include "shared/seen_sun.glsl"

real shell_altitude(uint k) { return scene.shell_altitudes[k]; }

#include "physics/shells.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D sun_table_out;

void main() {
  ivec2 size = textureSize(seen_lut, 0);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) {
    return;
  }
  real h = shell_altitude(uint(texel.y));
  real lifted = sun_table_mu(scene.planet, h, real(texel.x) / real(size.x - 1));
  SeenSun sun = seen_sun(h, sun_before_lift(h, lifted));
  real way = distance_to_top(scene.planet, h, sun.mu);
  real looked_up = distance_to_top(scene.planet, h, lifted);
  vec3 air = mean_extinction_to_top(scene.planet, h, sun.mu) * (way / max(looked_up, 1e-6));
  real spreading = -log(max(sun.spread, 1e-20)) / max(looked_up, 0.1 * optical_top());
  imageStore(sun_table_out, texel, vec4(air + vec3(spreading), 1.0));
  imageStore(sun_table_out, texel + ivec2(0, size.y), texelFetch(seen_lut, texel, 0));
}
