// Optical depth to the top of the atmosphere by quadrature: what the transmittance table holds.

// Optical depth along mu from altitude h, not clipped by the ground, by `steps` midpoints, dense toward the lowest
// point.
vec3 optical_depth_to_top(PlanetData planet, real h, real mu, uint steps) {
  Ray ray;
  ray.h = h;
  ray.mu = mu;
  ray.mu_sun = mu;
  ray.nu = 1.0;
  ray.length_ = distance_to_top(planet, h, mu);
  ray.at_ground = false;
  ray.falls = false;
  real falling = -(planet.ground_radius + h) * mu;
  uint before = falling_steps(falling, ray.length_, steps);
  vec3 depth = vec3(0.0);
  real start = 0.0;
  for (uint i = 0u; i < steps; i++) {
    real end = step_end(kStepsQuadratic, falling, ray.length_, before, i, steps);
    Step s = step_between(start, end);
    start = end;
    RayPoint point = point_on_ray(planet, ray, s.t);
    depth = depth + extinction_over(point.h, s.width * point.mu) * s.width;
  }
  return depth;
}
