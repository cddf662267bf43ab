#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud lets through, as a texel: of the sun's light by scattering, over that across its rays; radiance summed
// over the lower hemisphere times the cosine, for a sky and for a ground of radiance 1; of the sun's light unscattered.
// A second texel holds what it sends up: the first three sums over the upper hemisphere. It does not depend on the air. One workgroup.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"

layout(local_size_x = 256) in;
layout(scalar, set = 0, binding = 16) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 17) readonly buffer Sun { float values[]; } sun_planes;
layout(scalar, set = 0, binding = 19) readonly buffer Sky { float values[]; } sky_planes;
layout(scalar, set = 0, binding = 23) readonly buffer Ground { float values[]; } ground_planes;
layout(set = 0, binding = 18, rgba32f) uniform writeonly image2D sums_out;
layout(push_constant, scalar) uniform Push {
  uvec3 coarser;  // cells of sky and ground
};

shared vec4 sums[256];
shared vec4 up_sums[256];

void main() {
  CloudData c = cloud();
  uint thread = gl_LocalInvocationIndex;
  uint plane = c.coarse_x * c.coarse_y;
  uint coarser_plane = coarser.x * coarser.y;
  vec4 sum = vec4(0.0);
  vec4 up = vec4(0.0);
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    CloudOrdinate ordinate = ordinates.values[o];
    float share = ordinate.weight * abs(ordinate.direction.z);
    vec3 leaving = vec3(0.0);
    uint first = (2u * o + (c.coarse_z & 1u)) * plane;
    for (uint at = thread; at < plane; at += 256u) {
      leaving.x += sun_planes.values[first + at] * share / float(plane);
    }
    first = (2u * o + (coarser.z & 1u)) * coarser_plane;
    for (uint at = thread; at < coarser_plane; at += 256u) {
      leaving.y += sky_planes.values[first + at] * share / float(coarser_plane);
      leaving.z += ground_planes.values[first + at] * share / float(coarser_plane);
    }
    sum.xyz += ordinate.direction.z < 0.0 ? leaving : vec3(0.0);
    up.xyz += ordinate.direction.z < 0.0 ? vec3(0.0) : leaving;
  }
  for (uint at = thread; at < plane; at += 256u) {
    vec2 place = (vec2(at % c.coarse_x, at / c.coarse_x) + 0.5) / vec2(c.coarse_x, c.coarse_y);
    sum.w += exp(-c.scale * sun_depth_at(vec3(place, 0.0))) / float(plane);
  }
  sums[thread] = sum;
  up_sums[thread] = up;
  barrier();
  if (thread > 0u) {
    return;
  }
  for (uint i = 1u; i < 256u; i++) {
    sum += sums[i];
    up += up_sums[i];
  }
  imageStore(sums_out, ivec2(0), sum);
  imageStore(sums_out, ivec2(1, 0), up);
}
