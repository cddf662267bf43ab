#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud lets through, as a texel: of the sun's light by scattering, over that across its rays; radiance summed
// over the lower hemisphere times the cosine, for a sky and for a ground of radiance 1; of the sun's light unscattered.
// Three more texels hold the first three without the cosine, and then over the upper hemisphere with it and without. The
// fourth value of the second is of the sun's light unscattered or scattered forward alone.
// Then come the cells' levels of the light from all around (shared/cloud_around.glsl): its means over the field, and
// that of the sun's light unscattered; in the second row the means of this times the sky's, and times the ground's. None
// depends on the air. One workgroup.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "shared/cloud_around.glsl"

layout(local_size_x = 256) in;
layout(scalar, set = 0, binding = 16) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 17) readonly buffer Sun { float values[]; } sun_planes;
layout(scalar, set = 0, binding = 19) readonly buffer Sky { float values[]; } sky_planes;
layout(scalar, set = 0, binding = 23) readonly buffer Ground { float values[]; } ground_planes;
layout(set = 0, binding = 18, rgba32f) uniform writeonly image2D sums_out;
layout(set = 0, binding = 24) uniform sampler3D cloud_around_lut;
layout(push_constant, scalar) uniform Push {
  uvec3 coarser;  // cells of sky and ground
};

shared vec4 sums[256][4];

// The sum over the workgroup of what each thread has put aside in this column.
vec4 total(uint of) {
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < 256u; i++) {
    sum += sums[i][of];
  }
  return sum;
}

void sum_levels(CloudData c, uint thread) {
  uvec3 size = uvec3(textureSize(cloud_around_lut, 0)) - uvec3(1u, 1u, 0u);
  uint count = size.x * size.y;
  uint levels = size.z - kLevelsBelow - 1u;
  for (uint level = 0u; level < levels; level++) {
    float height = (float(level) + 0.5) / float(levels);
    vec4 light = vec4(0.0);
    vec4 lit = vec4(0.0);
    for (uint at = thread; at < count; at += 256u) {
      uvec2 cell = uvec2(at % size.x, at / size.x);
      vec3 here = texelFetch(cloud_around_lut, ivec3(cell + 1u, kLevelsBelow + level), 0).rgb;
      vec2 place = (vec2(cell) + 0.5) / vec2(size.xy);
      float sun = exp(-c.scale * sun_depth_at(vec3(place, height)));
      light += vec4(here, sun) / float(count);
      lit.xy += here.yz * (sun / float(count));
    }
    barrier();
    sums[thread][0] = light;
    sums[thread][1] = lit;
    barrier();
    if (thread < 2u) {
      imageStore(sums_out, ivec2(4u + level, thread), total(thread));
    }
  }
}

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
    uint first = o * plane;
    for (uint at = thread; at < plane; at += 256u) {
      leaving.x += sun_planes.values[first + at] * ordinate.weight / float(plane);
    }
    first = o * coarser_plane;
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
  if (thread < 4u) {
    imageStore(sums_out, ivec2(thread, 0), total(thread));
  }
  sum_levels(c, thread);
}
