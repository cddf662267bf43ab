#version 460
#extension GL_GOOGLE_include_directive : require
// Light of the ground as it comes to the base of a cloud's cells along each ordinate, over its mean: the ground among
// shadows of the cloud is darker than where the sun falls through gaps. First the light on the ground stands in the
// first plane: the sun's past the cloud, what the cloud scatters down, and that of a clear sky, even over the field.
// Then each ordinate stands for a share of the hemisphere, and takes the mean along nine directions of that share. One
// workgroup.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"
#include "shared/cloud_shares.glsl"

layout(local_size_x = 256) in;
layout(scalar, set = 0, binding = 16) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 17) readonly buffer Sun { float values[]; } sun_planes;
layout(scalar, set = 0, binding = 18) coherent buffer Ground { float values[]; } ground_out;
layout(push_constant, scalar) uniform Push { uvec2 cells; };

// The light of a clear sky over the sun's on level ground is this over the sine of the sun's height: 0.14 at 60
// degrees, 0.35 at 20.
const float kSkyShare = 0.12;

shared float sums[256];

// Between the middles of cells, which repeat themselves.
float sun_leaving(uint first, vec2 place) {
  vec2 at = place * vec2(cells) - 0.5;
  vec2 low = floor(at);
  vec2 part = at - low;
  uvec2 near = uvec2(low - floor(low / vec2(cells)) * vec2(cells)) % cells;
  uvec2 far = (near + 1u) % cells;
  uint near_row = first + near.y * cells.x;
  uint far_row = first + far.y * cells.x;
  return mix(mix(sun_planes.values[near_row + near.x], sun_planes.values[near_row + far.x], part.x),
             mix(sun_planes.values[far_row + near.x], sun_planes.values[far_row + far.x], part.x), part.y);
}

// On level ground, of a sun of irradiance 1 across its rays.
float light_on_ground(CloudData c, vec2 place, float mu_sun) {
  vec2 lean = vec2(c.sunward_east, c.sunward_north) * c.base;
  float sum = mu_sun * exp(-c.scale * sun_depth_at(vec3(place + lean / vec2(c.width, c.depth), 0.0)));
  for (uint o = 0u; o < kCloudOrdinates; o++) {
    CloudOrdinate ordinate = ordinates.values[o];
    if (ordinate.direction.z < 0.0) {
      vec2 shift = ordinate.direction.xy * (c.base / -ordinate.direction.z);
      sum -= ordinate.weight * ordinate.direction.z *
             sun_leaving(o * cells.x * cells.y, place - shift / vec2(c.width, c.depth));
    }
  }
  return sum;
}

void main() {
  CloudData c = cloud();
  uint thread = gl_LocalInvocationIndex;
  uint plane = cells.x * cells.y;
  float mu_sun = inversesqrt(1.0 + c.sunward_east * c.sunward_east + c.sunward_north * c.sunward_north);
  float sum = 0.0;
  for (uint at = thread; at < plane; at += 256u) {
    float light = light_on_ground(c, (vec2(at % cells.x, at / cells.x) + 0.5) / vec2(cells), mu_sun);
    ground_out.values[at] = light;
    sum += light;
  }
  sums[thread] = sum;
  memoryBarrierBuffer();
  barrier();
  float mean = 0.0;
  for (uint i = 0u; i < 256u; i++) {
    mean += sums[i] / float(plane);
  }
  float sky = mean * kSkyShare / mu_sun;
  for (uint n = thread; n < kCloudOrdinates * plane; n += 256u) {
    uint o = n / plane;
    CloudOrdinate ordinate = ordinates.values[o];
    if (ordinate.direction.z < 0.0) {
      continue;
    }
    uint at = n % plane;
    vec2 place = (vec2(at % cells.x, at / cells.x) + 0.5) / vec2(cells);
    float light = 0.0;
    for (uint k = 0u; k < kShareDirections; k++) {
      vec2 from = place - share_shift(ordinate, k) * c.base / vec2(c.width, c.depth);
      uvec2 cell = uvec2((from - floor(from)) * vec2(cells)) % cells;
      light += ground_out.values[cell.y * cells.x + cell.x] / float(kShareDirections);
    }
    ground_out.values[plane + n] = (light + sky) / max(mean + sky, 1e-20);
  }
}
