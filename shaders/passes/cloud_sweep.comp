#version 460
#extension GL_GOOGLE_include_directive : require
// Carries light through a cloud along each ordinate, plane by plane of cells across the axis of sweep_axis(): one
// workgroup an ordinate. Level planes begin at the top or the base. Upright ones begin with the light that the sweep
// before has left on the last of them, which is next to the first on the grid that repeats itself.
#include "shared/cloud_cells.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 2) readonly buffer Cells { float values[]; } cells;  // scaled extinction, 1/km
layout(scalar, set = 0, binding = 3) readonly buffer Sources { vec2 values[]; } sources;  // and their slopes
layout(scalar, set = 0, binding = 4) writeonly buffer Means { float values[]; } means_out;
layout(scalar, set = 0, binding = 5) coherent buffer Fronts { float values[]; } fronts;  // two an ordinate
layout(scalar, set = 0, binding = 6) writeonly buffer Planes { float values[]; } planes_out;
layout(scalar, set = 0, binding = 7) readonly buffer Ground { float values[]; } ground;  // cloud_ground.comp
layout(push_constant, scalar) uniform Push {
  uvec3 size;
  vec3 cell;     // sides, km
  float above;   // radiance that enters through the top
  float below;   // likewise through the base
  uint sweep;    // counted from 0
  uint longest;  // cells of the largest plane
  uint uneven;   // 1: `below` is the mean of what the ground sends
};

// A whole number of cells, counted on round a grid that repeats itself. (The remainder of a negative integer is not
// defined in SPIR-V.)
uint round_the_grid(float cells, uint count) { return uint(cells - floor(cells / float(count)) * float(count)) % count; }

void main() {
  uint ordinate = gl_WorkGroupID.x;
  vec3 direction = ordinates.values[ordinate].direction;
  bool up = direction.z > 0.0;
  float outside = up ? below : above;
  uint axis = sweep_axis(direction, cell * vec3(size), cell);
  float way = sweep_way(direction, cell, axis);
  uint u = axis == 0u ? 1u : 0u;  // axes of a plane
  uint v = axis == 2u ? 1u : 2u;
  uvec3 stride = uvec3(1u, size.x, size.x * size.y);
  uint count = stride.z * size.z;
  // A ray comes from here in the plane before, in cells.
  vec2 shift = -vec2(direction[u] / cell[u], direction[v] / cell[v]) * way;
  bool ends = v == 2u;  // rows end at top and base; else they repeat themselves
  for (uint k = 0u; k < size[axis]; k++) {
    uint layer = (direction[axis] > 0.0 ? k : size[axis] - 1u - k) * stride[axis];
    uint turn = (sweep * size[axis] + k) & 1u;
    uint from = (2u * ordinate + turn) * longest;
    uint to = (2u * ordinate + 1u - turn) * longest;
    bool enters = axis == 2u && k == 0u;
    vec2 moved = vec2(sweep_move(shift.x, k), sweep_move(shift.y, k));
    uint first = round_the_grid(moved.x, size[u]);
    uint first_row = round_the_grid(moved.y, size[v]);
    for (uint j = gl_LocalInvocationID.y; j < size[v]; j += 8u) {
      float row = float(j) + moved.y;
      bool from_outside = enters || (ends && (row < 0.0 || row >= float(size[v])));
      uint near = from + repeated(j + first_row, size[v]) * size[u];
      for (uint i = gl_LocalInvocationID.x; i < size[u]; i += 16u) {
        uint at = layer + j * stride[v] + i * stride[u];
        uint level = at / stride.z;
        uint column = at - level * stride.z;
        float entering = outside;
        if (uneven == 1u && up && level == 0u) {
          entering *= ground.values[(ordinate + 1u) * stride.z + column];
        }
        if (!from_outside) {
          entering = fronts.values[near + repeated(i + first, size[u])];
        }
        vec2 source = sources.values[ordinate * count + at];
        CellLight light = through_cell(entering, source.x, source.y, cells.values[at] * way);
        means_out.values[ordinate * count + at] = light.mean;
        fronts.values[to + j * size[u] + i] = light.leaving;
        if (level == (up ? size.z - 1u : 0u)) {
          planes_out.values[ordinate * stride.z + column] = light.leaving;
        }
      }
    }
    memoryBarrierBuffer();
    barrier();
  }
}
