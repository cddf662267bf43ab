#version 460
#extension GL_GOOGLE_include_directive : require
// The shares of light among terrain (physics/thing_light.glsl) in a grid: one workgroup a texel, one thread a
// direction.
#define AIRLIGHT_COARSE_SLOPES
#define AIRLIGHT_IN_ROUNDS
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "shared/things.glsl"
#include "physics/surface_light.glsl"
#include "physics/terrain_light.glsl"
#include "physics/sphere_light.glsl"
#include "shared/thing_shares.glsl"

vec3 fetch_cap(uint block, float x, float y, uint size) { return vec3(1.0); }  // without bodies
#include "physics/sky_caps.glsl"
#include "physics/things_light.glsl"

layout(set = 0, binding = 5) uniform sampler3D open_lut;  // thing_open.comp

// In 32 bits: a sampler's weights may have 8, and differences are taken.
vec3 fetch_open(uint block, uint direction, float row, float slice) {
  ivec2 last = textureSize(open_lut, 0).yz - 1;
  vec2 at = clamp(vec2(row, slice), vec2(0.0), vec2(last));
  ivec2 low = min(ivec2(at), last - 1);
  vec2 part = at - vec2(low);
  ivec3 texel = ivec3(block * kLightDirections + direction, low);
  vec3 near = mix(texelFetch(open_lut, texel, 0).rgb, texelFetch(open_lut, texel + ivec3(0, 1, 0), 0).rgb, part.x);
  vec3 far = mix(texelFetch(open_lut, texel + ivec3(0, 0, 1), 0).rgb,
                 texelFetch(open_lut, texel + ivec3(0, 1, 1), 0).rgb, part.x);
  return mix(near, far, part.y);
}

// A quotient of the light among terrain by that without; 1 where a sun far below the horizon sends none.
vec3 share_of(vec3 among, vec3 open) {
  const float kNone = 1e-20;  // of the sun's irradiance
  const float kMost = 1e3;
  return mix(vec3(1.0), min(among / max(open, vec3(kNone)), vec3(kMost)), greaterThan(open, vec3(kNone)));
}

#include "physics/thing_light.glsl"

layout(local_size_x = 64) in;  // kLightDirections
layout(set = 0, binding = 6, rgba32f) uniform writeonly image2D shares_out;
layout(push_constant, scalar) uniform Push {
  uint columns;
  uint rows;
  uint first_layer;  // kLightLayers: the surface alone
  uint first_round;  // 1: there are no shares yet
};

bool is_first_round() { return first_round != 0u; }

shared vec3 among_along[kLightDirections];
shared vec3 open_along[kLightDirections];
shared vec3 among_even[kLightDirections];
shared vec3 open_even[kLightDirections];

void main() {
  uint i = gl_LocalInvocationIndex;
  uvec2 texel = gl_WorkGroupID.yz;
  uint layer = first_layer + texel.y / rows;
  uvec2 cell = uvec2(texel.x, texel.y % rows);
  vec2 grid = vec2(cell) / vec2(float(columns - 1u), float(rows - 1u));
  TerrainData t = terrain_shape();
  vec2 at = map_from_grid(t, grid);
  Place place = place_in_grid(scene.planet, scene.camera.altitude, grid, layer);
  bool edge = cell.x == 0u || cell.y == 0u || cell.x + 1u == columns || cell.y + 1u == rows;
  if (!edge) {
    bool mirrored = ((cell.x + cell.y + layer) & 1u) != 0u;
    LightFrom light = light_from(scene.planet, scene.moments, scene.camera.altitude, scene.sun, place, i, mirrored);
    vec3 direction = light_direction(i, mirrored, scene.sun.direction);
    vec3 along = vec3(light_weight(i));
    float spacing = t.texel * float(max(t.columns, t.rows)) / (kMapShare * float(max(columns, rows)));
    if (layer < kLightLayers) {
      // Next to the camera, as air is seen before it, since nodes behind it count there too.
      float nu = dot(normalize(place.point + scene.camera.forward * spacing), direction);
      along *= diffuse_air(densities_at(min(place.h, scene.planet.atmosphere_height)), phases(nu)).phase_scattering;
    } else {
      along *= max(dot(grid_normal(place, at, spacing), direction), 0.0);
    }
    among_along[i] = along * light.among;
    open_along[i] = along * light.open;
    among_even[i] = light_weight(i) * light.among;
    open_even[i] = light_weight(i) * light.open;
  }
  barrier();
  if (i == 0u) {
    vec3 a = vec3(0.0);
    vec3 b = vec3(0.0);
    vec3 c = vec3(0.0);
    vec3 d = vec3(0.0);
    if (!edge) {
      for (uint k = 0u; k < kLightDirections; k++) {
        a += among_along[k];
        b += open_along[k];
        c += among_even[k];
        d += open_even[k];
      }
    }
    float base = surface_height(t, at.x, at.y);
    imageStore(shares_out, ivec2(texel), vec4(share_of(a, b), base));
    imageStore(shares_out, ivec2(texel) + ivec2(columns, 0), vec4(share_of(c, d), base));
  }
}
