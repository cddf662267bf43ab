// Light of the air on a cloud.

// Place in the table of moments, with rows at the edges of shells too.
MomentCoordinate air_moment_coordinate(MomentTableData table, real h, real mu_sun) {
  MomentCoordinate c = moment_coordinate(table, h, mu_sun);
  if (shell_rows() > 0u) {
    c.y = shell_coordinate(shell_of(h, true), h);
  }
  return c;
}

// Irradiance on a level plane by light scattered at least once, from above (side 1) or from below (-1), for a sun of
// irradiance 1: the field's harmonics of degree 0 to 2 that are even in azimuth, times the cosine.
vec3 level_irradiance(MomentCoordinate c, real side) {
  vec3 sum = vec3(0.5 * 0.28209479177387814);
  if (moment_degree() >= 1u) {
    sum = sum + fetch_moment(moment_place(1u, 0u), c.x, c.y) * (side * 0.48860251190291992 / 3.0);
  }
  if (moment_degree() >= 2u) {
    sum = sum + fetch_moment(moment_place(2u, 0u), c.x, c.y) * (0.31539156525252005 / 4.0);
  }
  return exp(fetch_moment(0u, c.x, c.y)) * max(sum, vec3(0.0)) * (2.0 * kPi);
}

// The light scattered at least once from all directions together, for a sun of irradiance 1.
vec3 light_from_all_around(MomentCoordinate c) {
  return max(exp(fetch_moment(0u, c.x, c.y)) * (2.0 * sqrt(kPi)), vec3(1e-30));
}

// Likewise from above (side 1) or from below (-1).
vec3 light_from_side(MomentCoordinate c, real side) {
  vec3 sum = vec3(sqrt(kPi));
  if (moment_degree() >= 1u) {
    sum = sum + fetch_moment(moment_place(1u, 0u), c.x, c.y) * (side * 0.48860251190291992 * kPi);
  }
  return exp(fetch_moment(0u, c.x, c.y)) * max(sum, vec3(0.0));
}
