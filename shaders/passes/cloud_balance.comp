#version 460
#extension GL_GOOGLE_include_directive : require
// How much light there is below a cloud, over that of a clear sky: light from below that the cloud sends down again
// included. One thread.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/cloud.h"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 20) readonly buffer Cloud { CloudData value; } cloud_data;
layout(set = 0, binding = 17) uniform sampler2D cloud_sums_lut;  // passes/cloud_sums.comp
layout(scalar, set = 0, binding = 18) writeonly buffer Light { CloudLight value; } light_out;

void main() {
  if (gl_GlobalInvocationID.x > 0u) {
    return;
  }
  CloudData c = cloud_data.value;
  vec4 sum = texelFetch(cloud_sums_lut, ivec2(0), 0);
  float mu_sun = scene.sun.direction.y;
  float h = optical_altitude_at(c.base);
  float facing = max(seen_sun_mu(scene.planet, h, mu_sun), 0.0);
  MomentCoordinate at = air_moment_coordinate(scene.moments, h, mu_sun);
  vec3 direct = transmittance_to_sun(scene.planet, h, mu_sun) * facing;
  vec3 sky = level_irradiance(at, 1.0);
  vec3 up = level_irradiance(at, -1.0);
  vec3 clear = max(direct + sky, vec3(1e-30));
  // The ordinates' sun has irradiance 1 across its rays.
  float through = sum.w + sum.x * length(vec3(c.sunward_east, c.sunward_north, 1.0));
  vec3 first = (direct * through + sky * sum.y / kPi) / clear;
  CloudLight light;
  light.below = first / max(vec3(1.0) - up / clear * (sum.z / kPi), vec3(0.05));
  light.direct = sum.w;
  light_out.value = light;
}
