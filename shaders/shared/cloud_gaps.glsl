// Where a cloud's grid holds no water.
layout(set = 0, binding = 24) uniform sampler3D cloud_gap_lut;  // cells to the nearest one that holds water

uvec3 gap_cells() { return uvec3(textureSize(cloud_gap_lut, 0)) - uvec3(1u, 1u, 0u); }

// Cells of the gaps' grid to the nearest water at least: it may stand two cells nearer than the interpolated gap says.
float empty_cells(vec3 place) {
  uvec3 cells = gap_cells();
  vec2 texel = vec2(cell_texel(place.x, cells.x), cell_texel(place.y, cells.y));
  return textureLod(cloud_gap_lut, vec3(texel / vec2(cells.xy + 1u), place.z), 0.0).r - 2.0;
}
