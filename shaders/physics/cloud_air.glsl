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

// Of the light from all around what comes from about the sun, and is shaded as its rays are: irradiance across these,
// for a sun of irradiance 1. Haze turns light little: a share chi_2 of what it scatters counts as not turned, as where
// harmonics are kept up to degree 1 [W76]. The table's degree 4 tells how much haze has scattered. There it has chi_4
// of its light; molecules have none, and a sky that brightens toward its horizon and the ground below have little.
// 0 where the table does not reach so far: haze is then thin.
vec3 light_around_sun(MomentCoordinate c, real h, real mu_sun) {
  const uint kDegree = 4u;
  const real kMost = 4.0;  // chi_2 over chi_4: what scatters more evenly has no peak
  if (moment_degree() < kDegree) {
    return vec3(0.0);
  }
  Densities d = densities_at(h);
  vec3 unturned = vec3(0.0);
  vec3 kept = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    if (i < medium_count()) {
      MediumData m = medium(i);
      vec3 chi = max(m.legendre[kDegree], vec3(0.0));
      kept = kept + m.scattering * d.of[i] * chi;
      unturned = unturned + m.scattering * d.of[i] * min(max(m.legendre[2], vec3(0.0)), chi * kMost);
    }
  }
  Harmonics y = harmonics(mu_sun, 1.0);
  vec3 sum = vec3(0.0);
  UNROLL for (uint m = 0u; m <= kDegree; m++) {
    uint k = moment_place(kDegree, m);
    sum = sum + fetch_moment(k, c.x, c.y) * y.of[k];
  }
  vec3 light = exp(fetch_moment(0u, c.x, c.y)) * max(sum, vec3(0.0)) * (4.0 * kPi / 9.0);
  return min(light * unturned / max(kept, vec3(1e-30)), light_from_all_around(c));
}
