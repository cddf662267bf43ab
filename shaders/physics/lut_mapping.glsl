// Each table's map from quantities to texture coordinates and its exact inverse, side by side.

// Unit range to the centres of the first and last texel, and back.
real texel_from_unit(real x, real n) { return (0.5 + x * (n - 1.0)) / n; }
real unit_from_texel(real u, real n) { return (u * n - 0.5) / (n - 1.0); }

// Transmittance to the top of the atmosphere over (mu, h) [B08 sec. 4, as evaluated in B17]: x from the distance to the
// top between its least (zenith) and greatest (horizon) value, y from the distance to the horizon. The ground never
// clips the distance to the top, neither in the map nor in its inverse.
struct TransmittanceCoordinate {
  real x;
  real y;
};
struct TransmittanceState {
  real h;
  real mu;
};

TransmittanceCoordinate transmittance_coordinate(PlanetData planet, real h, real mu) {
  real horizon_of_top = horizon_distance(planet, planet.atmosphere_height);
  real rho = horizon_distance(planet, h);
  real nearest = planet.atmosphere_height - h;
  real farthest = rho + horizon_of_top;
  // (distance_to_top() - its least value) / (its greatest value - its least value), as one quotient.
  real along = (planet.ground_radius + h) * mu;
  real across = 2.0 * planet.ground_radius + planet.atmosphere_height + h;
  real root = sqrt(max(along * along + nearest * across, 0.0));
  bool up = mu > 0.0;
  real excess = up ? nearest * (across - root - along) : root - along - nearest;
  real scale = up ? root + along : 1.0;
  TransmittanceCoordinate c;
  c.x = clamp(excess / (scale * (farthest - nearest)), 0.0, 1.0);
  c.y = clamp(rho / horizon_of_top, 0.0, 1.0);
  return c;
}

TransmittanceState transmittance_state(PlanetData planet, real x, real y) {
  real horizon_of_top = horizon_distance(planet, planet.atmosphere_height);
  real rho = y * horizon_of_top;
  TransmittanceState s;
  s.h = min(rho * rho / (planet.ground_radius + sqrt(planet.ground_radius * planet.ground_radius + rho * rho)),
            planet.atmosphere_height);
  real nearest = planet.atmosphere_height - s.h;
  real path = nearest + x * (rho + horizon_of_top - nearest);
  // horizon_of_top^2 - rho^2 as a product: both squares' roots are near 1100 km, and their difference is what counts.
  real gap = (horizon_of_top - rho) * (horizon_of_top + rho);
  s.mu = path <= 0.0
             ? 1.0
             : clamp((gap - path * path) / (2.0 * (planet.ground_radius + s.h) * path), -1.0, 1.0);
  return s;
}

// Multiple scattering over (mu_sun, h), both linear [H20 sec. 5.5.2].
struct ScatteringCoordinate {
  real x;
  real y;
};
struct ScatteringState {
  real h;
  real mu_sun;
};

ScatteringCoordinate scattering_coordinate(PlanetData planet, real h, real mu_sun) {
  ScatteringCoordinate c;
  real root = sqrt(abs(mu_sun));
  c.x = clamp(0.5 + 0.5 * (mu_sun < 0.0 ? -root : root), 0.0, 1.0);
  c.y = clamp(h / planet.atmosphere_height, 0.0, 1.0);
  return c;
}

ScatteringState scattering_state(PlanetData planet, real x, real y) {
  ScatteringState s;
  s.h = y * planet.atmosphere_height;
  real root = 2.0 * x - 1.0;
  s.mu_sun = root * abs(root);
  return s;
}
