#version 460
#extension GL_GOOGLE_include_directive : require
// Moments of one order of scattering at each node of the table: one workgroup a node, threads share the directions.
// Writes the order's own table (log form, the next order reads it) and adds the order to the sums.
#define AIRLIGHT_DEGREE_PUSHED
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/gathered_columns.glsl"
#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 15) const uint kFirstOrder = 0u;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D order_out;
// z in 0 to 1 from the horizon; weight; cosine of the azimuth; +1 above the horizon, -1 below.
layout(scalar, set = 0, binding = 5) readonly buffer Nodes { vec4 values[]; } nodes;
layout(scalar, set = 0, binding = 6) buffer Sums { vec4 values[]; } sums;
layout(push_constant, scalar) uniform Push {
  uint directions;
  uint panels;  // of two nodes; by shells unused
  uint suns;    // columns of the table that are gathered
  uint degree;  // of what the order takes from the one before, and keeps; at most the table's
};

// Pushed, so that all orders after the first are one pipeline.
uint source_degree() { return degree; }

const uint kThreads = 64u;
const uint kAtOnce = 16u;  // moments, each summed over the threads by one of them
const uint kStride = kAtOnce + 1u;  // of a thread's moments: odd, so that threads side by side use different banks
shared vec3 partial[kStride * kThreads];
shared vec3 isotropic;

// Whether the order keeps moment k.
bool is_kept(uint k) {
  return k < moment_place(source_degree() + 1u, 0u) || (k >= harmonic_count() && k <= moment_count());
}

// Sums the moments from `first` on over the threads that took a direction, and stores them. The irradiance comes last.
void store_moments(uint first, uvec2 node, uint lane, vec3 moments[kMaxMoments + 1u]) {
  if (first > moment_count()) {
    return;
  }
  uint busy = min(directions, kThreads);
  if (lane < busy) {
    UNROLL for (uint j = 0u; j < kAtOnce; j++) {
      if (is_kept(first + j)) {
        partial[lane * kStride + j] = moments[min(first + j, kMaxMoments)];
      }
    }
  }
  barrier();
  uint k = first + lane;
  bool mine = lane < kAtOnce && k <= moment_count();
  vec3 sum = vec3(0.0);
  if (mine && is_kept(k)) {
    for (uint i = 0u; i < busy; i++) {
      sum += partial[i * kStride + lane];
    }
    if (k == 0u) {
      isotropic = max(sum, vec3(1e-30));
    }
  }
  barrier();
  if (mine) {
    uvec2 at = uvec2(k * kMomentColumns + node.x, node.y);
    uint index = at.y * (moment_count() + 1u) * kMomentColumns + at.x;
    sums.values[index] += vec4(sum, 0.0);
    imageStore(order_out, ivec2(at), vec4(moment_code(k, sum, isotropic), 1.0));
  }
}

void main() {
  uvec2 node = uvec2(gathered_column(suns, gl_WorkGroupID.y), gl_WorkGroupID.z);
  uint lane = gl_LocalInvocationID.x;
  MomentState state = moment_state(scene.moments, float(node.x) / float(kMomentColumns - 1u),
                                   float(node.y) / float(kMomentRows - 1u));
  vec3 moments[kMaxMoments + 1u];
  UNROLL for (uint k = 0u; k <= kMaxMoments; k++) {
    moments[k] = vec3(0.0);
  }
  float sin_sun = sqrt(max(1.0 - state.mu_sun * state.mu_sun, 0.0));
  for (uint d = lane; d < directions; d += kThreads) {
    vec4 q = nodes.values[d];
    bool upward = q.w > 0.0;
    float mu = gather_mu(scene.planet, state.h, q.x, upward);
    float nu = mu * state.mu_sun + sqrt(max(1.0 - mu * mu, 0.0)) * sin_sun * q.z;
    Ray ray = ray_in_atmosphere(scene.planet, state.h, mu, state.mu_sun, nu);
    float weight = q.y * gather_range(scene.planet, state.h, upward);
    Stokes light;
    if (shell_rows() > 0u) {
      light = shell_order_radiance(scene.planet, scene.moments, ray, 1u, kFirstOrder != 0u);
    } else {
      light = order_radiance(scene.planet, scene.moments, ray, panels, kFirstOrder != 0u);
    }
    vec3 radiance = light.i * weight;
    Harmonics y = harmonics(mu, q.z);
    // Written out, or a software device keeps the sums in memory and steps through its lanes for each.
    UNROLL for (uint k = 0u; k < kMaxHarmonics; k++) {
      if (k < harmonic_count()) {
        moments[k] += radiance * y.of[k];
      }
    }
    if (polarised()) {
      Quadrupole a = quadrupole(mu, q.z);
      UNROLL for (uint m = 0u; m < kPolarisedMoments; m++) {
        moments[polarised_place(m)] +=
            radiance * y.of[moment_place(2u, m)] - (light.q * a.e[m] + light.u * a.f[m]) * weight;
      }
    }
    moments[moment_count()] += radiance * (upward ? mu : 0.0);
  }
  store_moments(0u, node, lane, moments);
  store_moments(16u, node, lane, moments);
  store_moments(32u, node, lane, moments);
  store_moments(48u, node, lane, moments);
}
