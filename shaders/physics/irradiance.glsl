// Directions over which the sky's irradiance on level ground is gathered: 8 x 8, spread by the cosine, so that the mean
// of their radiance times pi is the irradiance.

Ray irradiance_ray(PlanetData planet, real mu_sun, uint k) {
  real mu = sqrt((real(k / 8u) + 0.5) / 8.0);
  real azimuth = 2.0 * kPi * (real(k % 8u) + 0.5) / 8.0;
  real nu = mu * mu_sun + sqrt(max((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun), 0.0)) * cos(azimuth);
  return ray_in_atmosphere(planet, 0.0, mu, mu_sun, nu);
}

// The weight of each direction, sr.
real irradiance_weight() { return kPi / real(kGroundIrradianceDirections); }
