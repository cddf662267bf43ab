#version 460
#extension GL_GOOGLE_include_directive : require
// The light of all orders, F = first order + one order of F, nearer to what obeys this: what it lacks is handed on to all
// orders of it as if the air were level (core/luts/level_orders.h). One workgroup a sun, a thread a row.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/scene.h"
#include "shared/tables.h"
#include "shared/moment_shape.glsl"
#include "shared/gathered_columns.glsl"

layout(local_size_x = 64) in;  // kMaxShellRows
layout(constant_id = 16) const uint kLevelDegree = 2u;
layout(set = 0, binding = 1) uniform sampler2D first_order;
layout(set = 0, binding = 3) uniform sampler2D field;
layout(set = 0, binding = 5) uniform sampler2D gathered;  // one order of the field, at some suns
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D field_out;
layout(scalar, set = 0, binding = 6) readonly buffer Level { vec3 values[]; } level;
layout(push_constant, scalar) uniform Push {
  uint suns;   // of them an order was gathered at
  uint start;  // 1: there is no field yet, as if it were 0
};

const uint kMostLevelMoments = 18u;  // M_lm up to degree 4, and P_m
shared vec3 missing[kMostLevelMoments * 64u + 1u];

vec3 stored(sampler2D table, uint k, uint column, uint row) {
  return texelFetch(table, ivec2(k * kMomentColumns + column, row), 0).rgb;
}

// M_lm, or the irradiance.
vec3 value_in(sampler2D table, uint k, uint column, uint row) {
  return moment_of_code(k, stored(table, k, column, row), exp(stored(table, 0u, column, row)));
}

// What the field lacks of the first order and one order of itself.
vec3 missing_where_gathered(uint k, uint column, uint row) {
  return value_in(first_order, k, column, row) + value_in(gathered, k, column, row) - value_in(field, k, column, row);
}

// The same at every sun: the share of the field that it lacks is interpolated between the suns that were gathered.
vec3 missing_at(uint k, uint column, uint row) {
  if (start != 0u) {
    return value_in(first_order, k, column, row);
  }
  uint whole = k == moment_count() ? k : 0u;
  GatheredColumns near = gathered_around(suns, column);
  vec3 low = missing_where_gathered(k, near.low, row) / value_in(field, whole, near.low, row);
  vec3 high = missing_where_gathered(k, near.high, row) / value_in(field, whole, near.high, row);
  return (low + (high - low) * near.part) * value_in(field, whole, column, row);
}

vec3 field_at(uint k, uint column, uint row) { return start != 0u ? vec3(0.0) : value_in(field, k, column, row); }

// The share of a correction that leaves what it corrects within a factor of four of itself.
vec3 held(vec3 value, vec3 change) {
  vec3 most = start != 0u ? vec3(1e30) : 3.0 * value;
  vec3 least = 0.75 * value;
  vec3 up = most / max(change, vec3(1e-30));
  vec3 down = least / max(-change, vec3(1e-30));
  return min(vec3(1.0), mix(down, up, greaterThan(change, vec3(0.0))));
}

// The moments that level air couples, of one m: by l, then P_m. Places among all of them, and in the table.
uint level_harmonics() { return moment_place(kLevelDegree + 1u, 0u); }
uint level_moments() { return level_harmonics() + moment_count() - harmonic_count(); }
uint coupled(uint m) { return kLevelDegree + 1u - m + (polarised() && m < kPolarisedMoments ? 1u : 0u); }
uint coupled_place(uint j, uint m) {
  return j + m <= kLevelDegree ? moment_place(m + j, m) : level_harmonics() + m;
}
uint table_place(uint k) { return k < level_harmonics() ? k : polarised_place(k - level_harmonics()); }

void main() {
  uint column = gl_WorkGroupID.y;
  uint row = gl_LocalInvocationID.x;
  uint irradiance_place = level_moments() * kMomentRows;
  bool here = row < kMomentRows;
  if (here) {
    for (uint k = 0u; k < level_moments(); k++) {
      missing[k * kMomentRows + row] = missing_at(table_place(k), column, row);
    }
    if (row == 0u) {
      missing[irradiance_place] = missing_at(moment_count(), column, 0u);
    }
  }
  barrier();
  if (!here) {
    return;
  }
  vec3 more[kMostLevelMoments];
  for (uint k = 0u; k < level_moments(); k++) {
    more[k] = vec3(0.0);
  }
  uint at = row;
  for (uint m = 0u; m <= kLevelDegree; m++) {
    for (uint from = 0u; from < coupled(m); from++) {
      uint given = coupled_place(from, m) * kMomentRows;
      for (uint j = 0u; j < kMomentRows; j++) {
        vec3 light = missing[given + j];
        for (uint to = 0u; to < coupled(m); to++) {
          more[coupled_place(to, m)] += level.values[at] * light;
          at += kMomentRows;
        }
      }
    }
    if (m == 0u) {
      vec3 light = missing[irradiance_place];
      for (uint to = 0u; to < coupled(0u); to++) {
        more[coupled_place(to, 0u)] += level.values[at] * light;
        at += kMomentRows;
      }
    }
  }
  vec3 isotropic = field_at(0u, column, row);
  vec3 change = missing[row] + more[0];
  vec3 part = held(isotropic, change);
  isotropic = max(isotropic + part * change, vec3(1e-30));
  for (uint k = 0u; k < moment_count(); k++) {
    bool harmonic = k < harmonic_count();
    uint mine = harmonic ? k : level_harmonics() + k - harmonic_count();
    bool level_too = !harmonic || k < level_harmonics();
    change = missing_at(k, column, row) + (level_too ? more[min(mine, kMostLevelMoments - 1u)] : vec3(0.0));
    vec3 value = field_at(k, column, row) + part * change;
    vec3 code = moment_code(k, k == 0u ? isotropic : value, isotropic);
    imageStore(field_out, ivec2(k * kMomentColumns + column, row), vec4(code, 1.0));
  }
  uint k = moment_count();
  change = missing_at(k, column, row);
  if (row == 0u) {
    uint last = at - row;
    for (uint j = 0u; j < coupled(0u); j++) {
      for (uint i = 0u; i < kMomentRows; i++) {
        change += level.values[last + j * kMomentRows + i] * missing[coupled_place(j, 0u) * kMomentRows + i];
      }
    }
    change += level.values[last + coupled(0u) * kMomentRows] * missing[irradiance_place];
  }
  vec3 irradiance = field_at(k, column, row);
  vec3 value = irradiance + held(irradiance, change) * change;
  imageStore(field_out, ivec2(k * kMomentColumns + column, row), vec4(moment_code(k, value, isotropic), 1.0));
}
