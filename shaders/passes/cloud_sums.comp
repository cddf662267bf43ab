#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud lets through, as a texel: of the sun's light by scattering, over that across its rays; radiance summed
// over the lower hemisphere times the cosine, for a sky and for a ground of radiance 1; of the sun's light unscattered.
// Three more texels hold the first three without the cosine, and then over the upper hemisphere with it and without. The
// fourth value of the second is of the sun's light unscattered or scattered forward alone.
// It does not depend on the air. One workgroup.
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

shared vec4 sums[256][4];

void main() {
  CloudData c = cloud();
  uint thread = gl_LocalInvocationIndex;
  uint plane = c.coarse_x * c.coarse_y;
  uint coarser_plane = coarser.x * coarser.y;
  vec4 sum[4];
  for (uint n = 0u; n < 4u; n++) {
    sum[n] = vec4(0.0);
  }
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    CloudOrdinate ordinate = ordinates.values[o];
    vec3 leaving = vec3(0.0);
    uint first = (2u * o + (c.coarse_z & 1u)) * plane;
    for (uint at = thread; at < plane; at += 256u) {
      leaving.x += sun_planes.values[first + at] * ordinate.weight / float(plane);
    }
    first = (2u * o + (coarser.z & 1u)) * coarser_plane;
    for (uint at = thread; at < coarser_plane; at += 256u) {
      leaving.y += sky_planes.values[first + at] * ordinate.weight / float(coarser_plane);
      leaving.z += ground_planes.values[first + at] * ordinate.weight / float(coarser_plane);
    }
    uint side = ordinate.direction.z < 0.0 ? 0u : 2u;
    sum[side].xyz += leaving * abs(ordinate.direction.z);
    sum[side + 1u].xyz += leaving;
  }
  for (uint at = thread; at < plane; at += 256u) {
    vec2 place = (vec2(at % c.coarse_x, at / c.coarse_x) + 0.5) / vec2(c.coarse_x, c.coarse_y);
    float depth = c.scale * sun_depth_at(vec3(place, 0.0));
    sum[0].w += exp(-depth) / float(plane);
    sum[1].w += exp(-depth * c.turning) / float(plane);
  }
  sums[thread] = sum;
  barrier();
  if (thread > 3u) {
    return;
  }
  vec4 total = vec4(0.0);
  for (uint i = 0u; i < 256u; i++) {
    total += sums[i][thread];
  }
  imageStore(sums_out, ivec2(thread, 0), total);
}
