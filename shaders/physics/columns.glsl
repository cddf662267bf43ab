// Columns of media along rays in closed form, each medium as an exponential above a base (shared/analytic.h).

// exp(x^2) erfc(x) for x >= 0, within 0.09 %: exact at 0, in its slope there and at infinity.
real scaled_erfc(real x) {
  return (1.0 + x * (1.256019 + x * 0.550036)) / (1.0 + x * (2.384398 + x * (2.204375 + x * 0.974913)));
}

// Column along mu >= 0 over that straight up, for an exponential on a sphere: the leading term of Chapman's function,
// x = radius over scale height.
real chapman(real x, real mu) { return sqrt(0.5 * kPi * x) * scaled_erfc(mu * sqrt(0.5 * x)); }

// Column of density 1 above altitude h, km.
real column_above(AnalyticMedium a, real h) { return a.column * exp(-max(h - a.base, 0.0) / a.scale_height); }

// The same from altitude h to space along zenith cosine mu >= 0.
real column_outward(PlanetData planet, AnalyticMedium a, real h, real mu) {
  real z = max(h, a.base);
  real r = planet.ground_radius + h;
  real r_there = planet.ground_radius + z;
  real mu_there = sqrt(mu * mu * r * r + (z - h) * (r + r_there)) / r_there;
  return column_above(a, z) * chapman(r_there / a.scale_height, min(mu_there, 1.0));
}

// Altitude of the lowest point of the line through altitude h with zenith cosine mu; below 0 inside the planet.
real lowest_altitude(PlanetData planet, real h, real mu) {
  return h - (planet.ground_radius + h) * mu * mu / (1.0 + sqrt(max(1.0 - mu * mu, 0.0)));
}

// Column from altitude h to space along any mu, as if the planet were not in the way.
real column_to_space(PlanetData planet, AnalyticMedium a, real h, real mu) {
  real outward = column_outward(planet, a, h, abs(mu));
  if (mu >= 0.0) {
    return outward;
  }
  return max(2.0 * column_outward(planet, a, lowest_altitude(planet, h, mu), 0.0) - outward, 0.0);
}

vec3 mean_exponential3(vec3 a, vec3 b) {
  return vec3(mean_exponential(a.x, b.x), mean_exponential(a.y, b.y), mean_exponential(a.z, b.z));
}
