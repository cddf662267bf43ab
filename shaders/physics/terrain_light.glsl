// Light that terrain sends to the camera. It is Lambertian, lit by the sun past other terrain and by the sky.

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

// Radiance that leaves the terrain at distance `ground` along the track, for a sun of irradiance 1. The slope is taken
// over `footprint`, the pixel's width there, km.
vec3 terrain_radiance(PlanetData planet, MomentTableData table, vec3 sun, GroundTrack track, real ground,
                      real footprint) {
  TerrainData t = terrain_shape();
  real east = track.east * ground;
  real north = track.north * ground;
  real column = map_column(t, east, north);
  real row = map_row(t, east, north);
  real h = map_height(t, column, row);
  MapSlope slope = map_slope(t, column, row, max(0.5 * footprint / t.texel, 0.5));
  real slope_east = slope.across * t.across_east - slope.up * t.across_north;
  real slope_north = slope.across * t.across_north + slope.up * t.across_east;
  real slope_ahead = slope_east * track.east + slope_north * track.north;
  real slope_right = slope_east * track.north - slope_north * track.east;
  // Vertical, ahead and right at the place, in the camera's frame.
  real s = sin(ground / planet.ground_radius);
  real c = cos(ground / planet.ground_radius);
  vec3 up = vec3(track.east * s, c, -track.north * s);
  vec3 ahead = vec3(track.east * c, -s, -track.north * c);
  vec3 right = vec3(track.north, 0.0, track.east);
  vec3 normal = normalize(up - ahead * slope_ahead - right * slope_right);
  real mu = dot(normal, up);
  real mu_sun = dot(sun, up);
  vec3 level_normal = normal - up * mu;
  vec3 level_sun = sun - up * mu_sun;
  real lengths = length(level_normal) * length(level_sun);
  real cos_azimuth = lengths > 1e-7 ? clamp(dot(level_normal, level_sun) / lengths, -1.0, 1.0) : 1.0;
  real facing = max(dot(normal, sun), 0.0) * terrain_sunlit(t, east, north, h);
  vec3 irradiance = sun_through_air(planet, max(h, 0.0), mu_sun) * facing +
                    moment_irradiance(table, max(h, 0.0), mu_sun, mu, cos_azimuth);
  return map_albedo(t, column, row) * irradiance / kPi;
}
