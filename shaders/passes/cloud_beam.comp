#version 460
#extension GL_GOOGLE_include_directive : require
// The sun's light in a cloud's coarse cells over that above the cloud, delta-scaled: what their fine cells take out of
// it over the depth that the coarse cell has, so that no light is made or lost. A cell without water has what passes
// through it. One thread a cell.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "physics/segment.glsl"
#include "shared/cloud_volume.glsl"
#include "shared/cloud_sunlight.glsl"

const float kMostLevels = 4.0;  // of a part

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 2) writeonly buffer Beam { float values[]; } beam_out;
layout(scalar, set = 0, binding = 3) readonly buffer Extinctions { float values[]; } extinctions;  // scaled, 1/km
layout(push_constant, scalar) uniform Push { uvec3 cells; };

void main() {
  CloudData c = cloud();
  uint at = gl_GlobalInvocationID.x;
  if (at >= cells.x * cells.y * cells.z) {
    return;
  }
  uvec3 cell = uvec3(at % cells.x, at / cells.x % cells.y, at / (cells.x * cells.y));
  uvec3 parts = (uvec3(c.fine_x, c.fine_y, c.fine_z) + cells - 1u) / cells;
  // From a part's middle to where the sun's ray leaves it. A low sun's rays cross several parts from one level to the
  // next: parts are then less high.
  vec3 rise = vec3(vec2(c.sunward_east, c.sunward_north) / vec2(c.width, c.depth), 1.0 / (c.top - c.base));
  vec3 crossed = abs(rise) * vec3(cells * parts);
  float across = max(crossed.x, crossed.y);
  parts.z *= uint(clamp(ceil(across / crossed.z), 1.0, kMostLevels));
  vec3 half_way = 0.5 * rise / max(across, rise.z * float(cells.z * parts.z));
  float way = 2.0 * half_way.z * (c.top - c.base) * length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float count = float(parts.x * parts.y * parts.z);
  float taken = 0.0;
  float passing = 0.0;
  for (uint i = 0u; i < parts.x * parts.y * parts.z; i++) {
    vec3 part = vec3(i % parts.x, i / parts.x % parts.y, i / (parts.x * parts.y)) + 0.5;
    vec3 place = (vec3(cell) + part / vec3(parts)) / vec3(cells);
    float above = c.scale * sun_depth_at(place + half_way);
    float met = max(c.scale * sun_depth_at(place - half_way) - above, 0.0);
    float light = exp(-above) * mean_transmittance(met);
    taken += light * met;
    passing += light;
  }
  float held = extinctions.values[at] * way * count;
  beam_out.values[at] = held > 0.0 ? min(taken / held, 1.0) : passing / count;
}
