#version 460
#extension GL_GOOGLE_include_directive : require
// The aerial volume (physics/aerial_volume.glsl): one thread a direction, slice by slice away from the camera,
// or a team that shares its slices. Directions that the picture does not ask for hold no light.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "physics/aerial_volume.glsl"
#include "shared/sky_table_ray.glsl"
#include "shared/aerial_volume.glsl"

layout(local_size_x = 16, local_size_y = 4) in;
layout(constant_id = 27) const uint kTeam = 1u;  // threads a direction: 1, 2, 4, 8 or 16
layout(set = 0, binding = 4) uniform writeonly image3D volume_out;
layout(push_constant, scalar) uniform Push {
  uint steps;        // from slice to slice; at least 2
  float half_angle;  // of a cone around the picture's directions: others are not read
};

// Factors of a stretch of the ray, cut where the planet's shadow begins and ends.
SkyFactors stretch(Ray ray, ShadowCrossings shadow, float from, float to) {
  SkyFactors factors = no_air();
  float at = from;
  for (uint i = 0u; i < 3u && at < to; i++) {
    float edge = shadow.first > at ? shadow.first : shadow.second;
    float next = edge > at && edge < to ? edge : to;
    factors = joined(factors, scene_air_factors(part_of_ray(scene.planet, ray, at, next), steps));
    at = next;
  }
  return factors;
}

void store(uint block, uvec2 texel, uint slice, vec3 light) {
  imageStore(volume_out, ivec3(block * kSkyColumns + texel.x, texel.y, slice), vec4(volume_code(light), 1.0));
}

void store_slice(SkyFactors factors, Ray ray, uvec2 texel, uint slice) {
  vec3 scale = vec3(1.0) / max(gathered_share(factors.depth), vec3(1e-30));
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    if (scatters(i)) {
      store(single_block(i), texel, slice, factors.single[i] * scale);
    }
  }
  float nu = seen_cosine(scene.sun, ray.mu, ray.nu);
  vec3 light = factors.diffuse;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    light += folded(i) ? factors.single[i] * medium_phase(i, nu) : vec3(0.0);
  }
  store(diffuse_block(), texel, slice, light * scale / volume_carrier(nu));
}

// The first slice stands at the camera and holds the limit there, taken from a short way.
float slice_end(Ray ray, uint slice) {
  float z = slice == 0u ? 0.01 / float(kSlices) : float(slice) / float(kSlices - 1u);
  return slice_distance(scene.planet, ray, z);
}

// Gathers slices [first, last) behind `factors`, the light before them, and stores them if `stores`.
SkyFactors gather(SkyFactors factors, Ray ray, uvec2 texel, uint first, uint last, bool stores) {
  ShadowCrossings shadow = shadow_crossings(scene.planet, ray);
  float from = first == 0u ? 0.0 : slice_end(ray, first - 1u);
  for (uint slice = first; slice < last; slice++) {
    float to = slice_end(ray, slice);
    factors = joined(factors, stretch(ray, shadow, from, to));
    if (stores) {
      store_slice(factors, ray, texel, slice);
    }
    from = max(to, from);
  }
  return factors;
}

shared SkyFactors parts[64];

// Sum over the members of the team before this one.
SkyFactors before(SkyFactors own, uint part) {
  uint thread = gl_LocalInvocationIndex;
  parts[thread] = own;
  barrier();
  SkyFactors factors = no_air();
  for (uint i = 0u; i < part; i++) {
    factors = joined(factors, parts[thread - part + i]);
  }
  return factors;
}

// No texel is left undefined: a lookup multiplies what it does not want by 0, which keeps a NaN.
void store_nothing(uvec2 texel) {
  uint blocks = uint(imageSize(volume_out).x) / kSkyColumns;
  for (uint slice = 0u; slice < kSlices; slice++) {
    for (uint block = 0u; block < blocks; block++) {
      store(block, texel, slice, vec3(0.0));
    }
  }
}

void main() {
  uint rows = kGroundRows + kLimbRows + kSkyRows;
  uvec2 texel = uvec2(gl_GlobalInvocationID.y, gl_GlobalInvocationID.x / kTeam);
  uint part = gl_GlobalInvocationID.x % kTeam;
  bool in_table = texel.x < kSkyColumns && texel.y < rows;
  texel = min(texel, uvec2(kSkyColumns, rows) - 1u);
  bool stores = in_table && texel_is_read(texel, half_angle);
  if (in_table && !stores && part == 0u) {
    store_nothing(texel);
  }
  if (kTeam == 1u && !stores) {
    return;
  }
  Ray ray = table_ray(texel).ray;
  ray.length_ = stores ? ray.length_ : 0.0;  // the team takes no steps
  uint first = part * kSlices / kTeam;
  uint last = (part + 1u) * kSlices / kTeam;
  SkyFactors factors = no_air();
  if (kTeam > 1u) {
    SkyFactors own = gather(factors, ray, texel, first, last, false);
    factors = before(own, part);
    if (kSlices <= kTeam) {
      factors = joined(factors, own);
      if (stores && first < last) {
        store_slice(factors, ray, texel, first);
      }
      return;
    }
  }
  gather(factors, ray, texel, first, last, stores);
}
