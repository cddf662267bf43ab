#version 460
#extension GL_GOOGLE_include_directive : require
// Light from all around among clouds (shared/cloud_around.glsl), by where it comes from: of a sun of irradiance 1
// across its rays, scattered; of a sky and of a ground of radiance 1. Below the field it is what leaves the base and
// falls: each ordinate stands for a share of the hemisphere, and its light is taken along nine directions of that
// share. One thread a texel on the coarser cells; the first column and row are the last once more.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud.h"
#include "shared/cloud_around.glsl"
#include "shared/cloud_shares.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 2) readonly buffer Sun { float values[]; } sun_means;
layout(scalar, set = 0, binding = 3) readonly buffer Sky { float values[]; } sky_means;
layout(scalar, set = 0, binding = 4) readonly buffer Ground { float values[]; } ground_means;
layout(scalar, set = 0, binding = 5) readonly buffer SunPlanes { float values[]; } sun_planes;
layout(scalar, set = 0, binding = 6) readonly buffer SkyPlanes { float values[]; } sky_planes;
layout(scalar, set = 0, binding = 7) readonly buffer GroundPlanes { float values[]; } ground_planes;
layout(set = 0, binding = 8, rgba32f) uniform writeonly image3D around_out;
layout(scalar, set = 0, binding = 29) readonly buffer Cloud { CloudData value; } cloud_data;
layout(push_constant, scalar) uniform Push {
  uvec3 coarser;  // cells of sky and ground
};

const float kTurn = 6.283185307179586;

// The eight cells around a place, the nearer one and the farther one on each axis.
struct Corners {
  uvec3 near;
  uvec3 far;
  vec3 part;
};

Corners corners_of(vec3 place, uvec3 cells) {
  vec3 at = place * vec3(cells) - 0.5;
  at.xy -= floor(at.xy / vec2(cells.xy)) * vec2(cells.xy);
  at.z = clamp(at.z, 0.0, float(cells.z - 1u));
  Corners a;
  a.near = min(uvec3(at), cells - 1u);
  a.part = at - vec3(a.near);
  a.far = uvec3((a.near.xy + 1u) % cells.xy, min(a.near.z + 1u, cells.z - 1u));
  return a;
}

// Cell and share of corner n.
uint corner(Corners a, uvec3 cells, uint n) {
  uvec3 at = mix(a.near, a.far, bvec3((n & 1u) != 0u, (n & 2u) != 0u, (n & 4u) != 0u));
  return (at.z * cells.y + at.y) * cells.x + at.x;
}

float share_of(Corners a, uint n) {
  vec3 share = mix(1.0 - a.part, a.part, bvec3((n & 1u) != 0u, (n & 2u) != 0u, (n & 4u) != 0u));
  return share.x * share.y * share.z;
}

// In a coarser cell: of sky and ground its own light, of the sun that of the finer cells around its middle.
vec3 inside(uvec3 cell, uvec3 sunlit) {
  Corners a = corners_of((vec3(cell) + 0.5) / vec3(coarser), sunlit);
  uint at = (cell.z * coarser.y + cell.y) * coarser.x + cell.x;
  uint count = coarser.x * coarser.y * coarser.z;
  uint sunlit_count = sunlit.x * sunlit.y * sunlit.z;
  vec3 sum = vec3(0.0);
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    vec3 light = vec3(0.0, sky_means.values[o * count + at], ground_means.values[o * count + at]);
    for (uint n = 0u; n < 8u; n++) {
      light.x += share_of(a, n) * sun_means.values[o * sunlit_count + corner(a, sunlit, n)];
    }
    sum += light * ordinates.values[o].weight;
  }
  return sum;
}

// What leaves the field along an ordinate, at a place of its base or top.
vec3 leaving(uint o, vec2 place, uvec3 sunlit) {
  uvec3 level = uvec3(coarser.xy, 1u);
  uvec3 sunlit_level = uvec3(sunlit.xy, 1u);
  Corners a = corners_of(vec3(place, 0.5), level);
  Corners b = corners_of(vec3(place, 0.5), sunlit_level);
  uint first = o * level.x * level.y;
  uint sunlit_first = o * sunlit_level.x * sunlit_level.y;
  vec3 light = vec3(0.0);
  for (uint n = 0u; n < 4u; n++) {
    uint at = first + corner(a, level, n);
    light += vec3(share_of(b, n) * sun_planes.values[sunlit_first + corner(b, sunlit_level, n)],
                  share_of(a, n) * vec2(sky_planes.values[at], ground_planes.values[at]));
  }
  return light;
}

// So many km under the base: what falls.
vec3 under(vec2 place, float depth, uvec3 sunlit) {
  CloudData c = cloud_data.value;
  vec3 sum = vec3(0.0);
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    if (ordinates.values[o].direction.z > 0.0) {
      continue;
    }
    for (uint k = 0u; k < kShareDirections; k++) {
      vec2 shift = share_shift(ordinates.values[o], k) * depth;
      sum += leaving(o, place - shift / vec2(c.width, c.depth), sunlit) *
             (ordinates.values[o].weight / float(kShareDirections));
    }
  }
  return sum;
}

vec3 at_top(vec2 place, uvec3 sunlit) {
  vec3 sum = vec3(0.0, kTurn, 0.0);  // the sky above
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    if (ordinates.values[o].direction.z > 0.0) {
      sum += leaving(o, place, sunlit) * ordinates.values[o].weight;
    }
  }
  return sum;
}

void main() {
  uvec3 at = gl_GlobalInvocationID;
  uint levels = kLevelsBelow + coarser.z + 1u;
  if (at.x > coarser.x || at.y > coarser.y || at.z >= levels) {
    return;
  }
  CloudData c = cloud_data.value;
  uvec3 sunlit = uvec3(c.coarse_x, c.coarse_y, c.coarse_z);
  uvec2 column = (at.xy + coarser.xy - 1u) % coarser.xy;
  vec2 place = (vec2(column) + 0.5) / vec2(coarser.xy);
  vec3 light;
  if (at.z < kLevelsBelow) {
    light = under(place, c.base * (1.0 - float(at.z) / float(kLevelsBelow)), sunlit);
  } else if (at.z < levels - 1u) {
    light = inside(uvec3(column, at.z - kLevelsBelow), sunlit);
  } else {
    light = at_top(place, sunlit);
  }
  imageStore(around_out, ivec3(at), vec4(light, 1.0));
}
