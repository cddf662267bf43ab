// The surface of terrain, which is Lambertian.

// Slopes of the terrain along the map's columns and rows over `reach` columns.
struct MapSlope {
  real across;  // km a km
  real up;
};

MapSlope map_slope(TerrainData t, real column, real row, real reach) {
  MapSlope slope;
  real span = 2.0 * reach * t.texel;
  slope.across = (map_height(t, column + reach, row) - map_height(t, column - reach, row)) / span;
  slope.up = (map_height(t, column, row - reach) - map_height(t, column, row + reach)) / span;
  return slope;
}

vec3 map_albedo(TerrainData t, real column, real row) {
  real x = column / real(t.columns - 1u) * real(t.colour_columns) - 0.5;
  real y = row / real(t.rows - 1u) * real(t.colour_rows) - 0.5;
  x = clamp(x, 0.0, real(t.colour_columns - 1u));
  y = clamp(y, 0.0, real(t.colour_rows - 1u));
  uint i = uint(x);
  uint j = uint(y);
  uint right = min(i + 1u, t.colour_columns - 1u);
  uint below = min(j + 1u, t.colour_rows - 1u);
  real u = x - real(i);
  real v = y - real(j);
  vec3 upper = terrain_colour(j * t.colour_columns + i) * (1.0 - u) + terrain_colour(j * t.colour_columns + right) * u;
  vec3 lower =
      terrain_colour(below * t.colour_columns + i) * (1.0 - u) + terrain_colour(below * t.colour_columns + right) * u;
  return upper * (1.0 - v) + lower * v;
}

struct Slope {
  real h;  // altitude, km
  vec3 normal;
  vec3 albedo;
};

// The terrain at a place of the map; `up`: the vertical there. The slope is taken over `footprint`, a pixel's width
// there, km.
Slope terrain_slope(real east, real north, vec3 up, real footprint) {
  TerrainData t = terrain_shape();
  real column = map_column(t, east, north);
  real row = map_row(t, east, north);
  MapSlope slope = map_slope(t, column, row, max(0.5 * footprint / t.texel, 0.5));
  real slope_east = slope.across * t.across_east - slope.up * t.across_north;
  real slope_north = slope.across * t.across_north + slope.up * t.across_east;
  Slope found;
  found.h = map_height(t, column, row);
  found.normal = from_level(up, normalize(vec3(-slope_east, 1.0, slope_north)));
  found.albedo = map_albedo(t, column, row);
  return found;
}
