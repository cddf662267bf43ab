#version 460
#extension GL_GOOGLE_include_directive : require
// How much light there is below a cloud, over that of a clear sky: light from below that the cloud sends down again
// included. One workgroup.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/shells.glsl"
#include "physics/cloud_air.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"

layout(local_size_x = 256) in;
layout(scalar, set = 0, binding = 16) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 17) readonly buffer Sun { float values[]; } sun_planes;
layout(scalar, set = 0, binding = 19) readonly buffer Sky { float values[]; } sky_planes;
layout(scalar, set = 0, binding = 23) readonly buffer Ground { float values[]; } ground_planes;
layout(push_constant, scalar) uniform Push {
  uvec3 coarser;  // cells of sky and ground
};
layout(scalar, set = 0, binding = 18) writeonly buffer Light { CloudLight value; } light_out;

shared vec4 sums[256];

void main() {
  CloudData c = cloud();
  uint thread = gl_LocalInvocationIndex;
  uint plane = c.coarse_x * c.coarse_y;
  uint coarser_plane = coarser.x * coarser.y;
  vec4 sum = vec4(0.0);
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    CloudOrdinate ordinate = ordinates.values[o];
    if (ordinate.direction.z < 0.0) {
      float share = -ordinate.weight * ordinate.direction.z;
      uint first = (2u * o + (c.coarse_z & 1u)) * plane;
      for (uint at = thread; at < plane; at += 256u) {
        sum.x += sun_planes.values[first + at] * share / float(plane);
      }
      first = (2u * o + (coarser.z & 1u)) * coarser_plane;
      for (uint at = thread; at < coarser_plane; at += 256u) {
        sum.y += sky_planes.values[first + at] * share / float(coarser_plane);
        sum.z += ground_planes.values[first + at] * share / float(coarser_plane);
      }
    }
  }
  for (uint at = thread; at < plane; at += 256u) {
    vec2 place = (vec2(at % c.coarse_x, at / c.coarse_x) + 0.5) / vec2(c.coarse_x, c.coarse_y);
    sum.w += exp(-c.scale * sun_depth_at(vec3(place, 0.0))) / float(plane);
  }
  sums[thread] = sum;
  barrier();
  if (thread > 0u) {
    return;
  }
  for (uint i = 1u; i < 256u; i++) {
    sum += sums[i];
  }
  float mu_sun = scene.sun.direction.y;
  float facing = max(mu_sun, 0.0);
  MomentCoordinate at = air_moment_coordinate(scene.moments, c.base, mu_sun);
  vec3 direct = transmittance_to_sun(scene.planet, c.base, mu_sun) * facing;
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
