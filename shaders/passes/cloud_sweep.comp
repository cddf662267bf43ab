#version 460
#extension GL_GOOGLE_include_directive : require
// Carries light through a cloud along each ordinate, layer by layer: one workgroup an ordinate.
#include "shared/cloud_cells.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, set = 0, binding = 1) readonly buffer Ordinates { CloudOrdinate values[]; } ordinates;
layout(scalar, set = 0, binding = 2) readonly buffer Cells { float values[]; } cells;  // scaled extinction, 1/km
layout(scalar, set = 0, binding = 3) readonly buffer Sources { vec2 values[]; } sources;  // and their slopes
layout(scalar, set = 0, binding = 4) writeonly buffer Means { float values[]; } means_out;
layout(scalar, set = 0, binding = 5) coherent buffer Planes { float values[]; } planes;  // two an ordinate
layout(push_constant, scalar) uniform Push {
  uvec3 size;
  vec3 cell;    // sides, km
  float above;  // radiance that enters through the top
  float below;  // likewise through the base
};

void main() {
  uint ordinate = gl_WorkGroupID.x;
  vec3 direction = ordinates.values[ordinate].direction;
  bool up = direction.z > 0.0;
  uint plane = size.x * size.y;
  float way = cell.z / abs(direction.z);
  // A ray through the middle of a cell comes from here in the layer before.
  vec2 shift = -direction.xy * (way / cell.xy);
  vec2 whole = floor(shift);
  vec2 part = shift - whole;
  uvec2 first = uvec2(whole - floor(whole / vec2(size.xy)) * vec2(size.xy)) % size.xy;
  for (uint k = 0u; k < size.z; k++) {
    uint layer = (up ? k : size.z - 1u - k) * plane;
    uint rays = ordinate * (size.z * plane) + layer;
    uint from = (2u * ordinate + (k & 1u)) * plane;
    uint to = (2u * ordinate + (1u - (k & 1u))) * plane;
    for (uint j = gl_LocalInvocationID.y; j < size.y; j += 16u) {
      uint row = repeated(j + first.y, size.y);
      uint near_row = from + row * size.x;
      uint far_row = from + repeated(row + 1u, size.y) * size.x;
      for (uint i = gl_LocalInvocationID.x; i < size.x; i += 16u) {
        float entering = up ? below : above;
        if (k > 0u) {
          uint near = repeated(i + first.x, size.x);
          uint far = repeated(near + 1u, size.x);
          entering = mix(mix(planes.values[near_row + near], planes.values[near_row + far], part.x),
                         mix(planes.values[far_row + near], planes.values[far_row + far], part.x), part.y);
        }
        uint at = j * size.x + i;
        vec2 source = sources.values[rays + at];
        CellLight light = through_cell(entering, source.x, source.y, cells.values[layer + at] * way);
        means_out.values[rays + at] = light.mean;
        planes.values[to + at] = light.leaving;
      }
    }
    memoryBarrierBuffer();
    barrier();
  }
}
