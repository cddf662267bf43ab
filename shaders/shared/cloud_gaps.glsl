// Where a cloud's grid holds no water.
layout(set = 0, binding = 24) uniform sampler3D cloud_gap_lut;  // cells to the nearest one that holds water

uvec3 gap_cells() { return uvec3(textureSize(cloud_gap_lut, 0)) - uvec3(1u, 1u, 0u); }

// Cells of the gaps' grid from any place of this one's cell to the nearest water at least, which reaches a quarter of a
// cell out of its own. One texel, not a mean of eight: devices without texture units load them one by one.
float empty_cells(vec3 place) {
  uvec3 cells = gap_cells();
  vec2 across = (place.xy - floor(place.xy)) * vec2(cells.xy);
  uint level = uint(clamp(place.z * float(cells.z), 0.0, float(cells.z - 1u)));
  uvec3 cell = uvec3(min(uvec2(across), cells.xy - 1u), level);
  return texelFetch(cloud_gap_lut, ivec3(cell.xy + 1u, cell.z), 0).r - 1.25;
}
