// Light that reaches a surface in the air, by the tables of `orders`.

// Irradiance of a surface of any slope by the light that the table of moments holds. A cosine spreads the harmonics of
// degree l by pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64, 0, -pi/128 (Ramamoorthi and Hanrahan, An Efficient Representation
// for Irradiance Environment Maps, SIGGRAPH 2001). mu: zenith cosine of the normal; azimuth from the sun's.
vec3 moment_irradiance(MomentTableData table, real h, real mu_sun, real mu, real cos_azimuth) {
  DiffuseAir cosine;
  cosine.extinction = vec3(0.0);
  cosine.peaks = vec3(0.0);
  cosine.phase_scattering = vec3(0.0);
  cosine.dipoles = vec3(0.0);
  cosine.degree[0] = vec3(kPi);
  cosine.degree[1] = vec3(kPi * 2.0 / 3.0);
  cosine.degree[2] = vec3(kPi / 4.0);
  cosine.degree[4] = vec3(-kPi / 24.0);
  cosine.degree[6] = vec3(kPi / 64.0);
  cosine.degree[8] = vec3(-kPi / 128.0);
  MomentCoordinate c = moment_coordinate(table, h, mu_sun);
  if (shell_rows() > 0u) {
    c.y = shell_coordinate(shell_of(h, true), h);
  }
  Harmonics y = harmonics(mu, cos_azimuth);
  vec3 sum = cosine.degree[0] * y.of[0];
  sum = with_degree(sum, 1u, source_degree(), c, cosine, y);
  sum = with_degree(sum, 2u, source_degree(), c, cosine, y);
  sum = with_degree(sum, 4u, source_degree(), c, cosine, y);
  sum = with_degree(sum, 6u, source_degree(), c, cosine, y);
  sum = with_degree(sum, 8u, source_degree(), c, cosine, y);
  return max(sum, vec3(0.0)) * exp(fetch_moment(0u, c.x, c.y));
}

// Transmittance toward the sun from altitude h, zero in the planet's shadow.
vec3 sun_through_air(PlanetData planet, real h, real mu_sun) {
  if (shell_rows() > 0u) {
    real lit = meets_ground(planet, h, mu_sun) ? 0.0 : 1.0;
    return exp(-sun_depth(planet, h, shell_coordinate(shell_of(h, true), h), mu_sun)) * lit;
  }
  return transmittance_to_sun(planet, h, mu_sun);
}

// The sky's irradiance on a surface with this normal.
vec3 sky_irradiance(MomentTableData table, Place place, vec3 normal, PlaceSun sun) {
  real mu = clamp(dot(normal, place.up), -1.0, 1.0);
  vec3 level_normal = normal - place.up * mu;
  vec3 level_sun = sun.seen - place.up * dot(sun.seen, place.up);
  real lengths = length(level_normal) * length(level_sun);
  real cos_azimuth = lengths > 1e-7 ? clamp(dot(level_normal, level_sun) / lengths, -1.0, 1.0) : 1.0;
  return moment_irradiance(table, sun.h, sun.mu, mu, cos_azimuth);
}

// Mean of the irradiance over all normals: a quarter of the light from all around, half of a hemisphere's if that is
// even.
vec3 mean_sky_irradiance(MomentTableData table, PlaceSun sun) {
  MomentCoordinate c = moment_coordinate(table, sun.h, sun.mu);
  if (shell_rows() > 0u) {
    c.y = shell_coordinate(shell_of(sun.h, true), sun.h);
  }
  return exp(fetch_moment(0u, c.x, c.y)) * (kPi * 0.28209479177387814);
}
