#version 460
#extension GL_GOOGLE_include_directive : require
// A pixel from the picture's table of factors: one fetch for each medium that scatters, times its phase function, and
// one for the diffuse light. The aureole is as sharp as the phase function, however coarse the table.
#include "shared/device.glsl"
#include "shared/sky_table.glsl"
#include "shared/sky_output.glsl"
#include "physics/sky_table.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1) uniform sampler2D factors_lut;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

vec3 fetch_factor(uint block, float x, float v) {
  float blocks = float(bitCount(kScatteringMedia) + 1u);
  float u = (float(block * kSkyColumns) + 0.5 + x * float(kSkyColumns - 1u)) / (blocks * float(kSkyColumns));
  return textureLod(factors_lut, vec2(u, v), 0.0).rgb;
}

vec3 single_at(uint i, float x, float v, float nu) {
  if (scatters(i)) {
    return fetch_factor(single_block(i), x, v) * medium_phase(i, nu);
  }
  return vec3(0.0);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  vec3 d = view.direction;
  vec3 s = scene.sun.direction;
  // Azimuth from the sun's, 0 to pi; the tiny term keeps atan away from (0, 0) at the zenith.
  float azimuth = atan(abs(d.x * s.z - d.z * s.x) + 1e-20, d.x * s.x + d.z * s.z);
  SkyTableCoordinate c = sky_table_coordinate(scene.planet, scene.camera.altitude, d.y, azimuth);
  float rows = float(kGroundRows + kLimbRows + kSkyRows);
  float v = (float(section_first(c.section)) + 0.5 + c.y * float(section_rows(c.section) - 1u)) / rows;
  float nu = dot(d, s);
  vec3 sum = fetch_factor(diffuse_block(), c.x, v);
  sum += single_at(0u, c.x, v, nu);
  sum += single_at(1u, c.x, v, nu);
  sum += single_at(2u, c.x, v, nu);
  sum += single_at(3u, c.x, v, nu);
  sum += single_at(4u, c.x, v, nu);
  sum += single_at(5u, c.x, v, nu);
  sum += single_at(6u, c.x, v, nu);
  sum += single_at(7u, c.x, v, nu);
  write_radiance(pixel, view.inside, sum, vec3(1.0));
}
