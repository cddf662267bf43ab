#version 460
#extension GL_GOOGLE_include_directive : require
// Optical depth of a cloud toward the sun: one thread a ray of the sun, which it follows down from the cloud's top.
// Column and row are where the ray enters the top: the grid leans as the sun's rays do. Slices are heights, evenly from
// base to top.
//
// Of a cloud whose edge is carved finer than the grid a thread follows four rays, in the middles of the quarters of its
// texel, through the carved water. The depth is that which leaves as much light as the four do: through gaps between
// lobes falls light where the grid's means would shade. `scale` is that of delta scaling: the mean is of scaled light.
// Where the sun is low, one ray does: it meets many lobes.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define UNROLL [[unroll]]
#define DONT_UNROLL [[dont_unroll]]
#define real float
#include "shared/cloud_volume.glsl"
#include "shared/cloud_carved.glsl"
#include "shared/cloud_gaps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 2) writeonly buffer Depths { float values[]; } depths_out;  // as an image has texels
layout(push_constant, scalar) uniform Push {
  uint slices;  // heights, one less than there are
  uint parts;   // of a slice
  float scale;
  uint rays;  // of a carved edge: 1 or kRays
};

const uint kRays = 4u;

// So far inside the cloud the rays about a place all meet full water, or none.
bool is_even(float inside) {
  CloudEdge edge = cloud().edge;
  float beside = 0.5 * cloud().width / float(cloud().fine_x);  // more than a ray stands off
  return inside < -beside || inside > edge.carving + edge.soft + beside;
}

float water_of_ray(vec3 place) { return carved_extinction(place, water_at(place).y, 1.0); }

// The depth that leaves the mean of what these leave.
float mean_depth(float depths[kRays]) {
  float least = min(min(depths[0], depths[1]), min(depths[2], depths[3]));
  float left = 0.0;
  UNROLL for (uint r = 0u; r < kRays; r++) {
    left += exp(scale * (least - depths[r])) / float(kRays);
  }
  return rays == 1u ? depths[0] : least - log(left) / scale;
}

// Of a column and row, at a slice.
uint place_of(uvec2 at, uint slice, CloudData c) { return (slice * (c.fine_y + 1u) + at.y) * (c.fine_x + 1u) + at.x; }

void main() {
  CloudData c = cloud();
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x > c.fine_x || at.y > c.fine_y) {
    return;
  }
  float height = c.top - c.base;
  vec2 lean = vec2(c.sunward_east * height / c.width, c.sunward_north * height / c.depth);
  float way = length(vec3(c.sunward_east, c.sunward_north, 1.0)) * height;
  uint steps = parts * slices;
  vec3 cells = vec3(gap_cells()) * vec3(abs(lean), 1.0) / float(steps);
  float cells_of_step = max(max(cells.x, cells.y), cells.z);
  float depths[kRays];
  UNROLL for (uint r = 0u; r < kRays; r++) {
    depths[r] = 0.0;
  }
  depths_out.values[place_of(at, slices, c)] = 0.0;
  uint written = 0u;  // slices below the top
  uint i = 0u;
  while (i < steps) {
    float down = (float(i) + 0.5) / float(steps);
    vec3 place = vec3(vec2(at) / vec2(c.fine_x, c.fine_y) - lean * down, 1.0 - down);
    float empty = empty_cells(place);
    vec2 mean = water_at(place);
    bool even = kCarved == 0u || is_even(mean.y);
    if (even && empty < 0.5) {
      // An edge that takes nothing off needs no noise.
      float full = mean.y > 0.0 ? edge_extinction(c.edge, place.z, mean.y, 0.0) : 0.0;
      float extinction = kCarved == 0u ? mean.x : full;
      UNROLL for (uint r = 0u; r < kRays; r++) {
        depths[r] += extinction * way / float(steps);
      }
    }
    // Unrolled, all four would be run where there is no water.
    uint followed = !even && empty < 0.5 ? rays : 0u;
    DONT_UNROLL for (uint r = 0u; r < followed; r++) {
      vec2 beside = rays == 1u ? vec2(0.0) : (vec2(r & 1u, r >> 1u) - 0.5) * 0.5 / vec2(c.fine_x, c.fine_y);
      depths[r] += water_of_ray(place + vec3(beside, 0.0)) * way / float(steps);
    }
    // Over empty cells the ray leaps.
    i = min(i + uint(max(empty / cells_of_step, 1.0)), steps);
    float depth = 0.0;
    if ((written + 1u) * parts <= i) {
      depth = kCarved == 0u ? depths[0] : mean_depth(depths);
    }
    while ((written + 1u) * parts <= i) {
      written++;
      depths_out.values[place_of(at, slices - written, c)] = depth;
    }
  }
}
