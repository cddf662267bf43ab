// Axis of the table of extinction between camera and ground (ground_extinction.glsl).

// The table holds mean extinction over the logarithm of the way through the air, from straight down to the horizon.
struct ViewRange {
  real top;  // altitude where the rays start, km
  real nearest;
  real farthest;
};

ViewRange view_range(PlanetData planet, real h) {
  ViewRange range;
  range.top = clamp(h, 1e-6, planet.atmosphere_height);
  range.nearest = range.top;
  range.farthest = horizon_distance(planet, range.top);
  return range;
}

real unit_from_way(ViewRange range, real way) {
  return clamp(log(max(way, 1e-9) / range.nearest) / log(range.farthest / range.nearest), 0.0, 1.0);
}

// The ray up from the ground whose way is at x; its optical depth goes into the table.
Ray ray_of_unit(PlanetData planet, ViewRange range, real x) {
  real way = range.nearest * exp(log(range.farthest / range.nearest) * x);
  real rise = range.top * (2.0 * planet.ground_radius + range.top) - way * way;
  Ray ray;
  ray.h = 0.0;
  ray.mu = clamp(rise / (2.0 * planet.ground_radius * way), 0.0, 1.0);
  ray.mu_sun = 0.0;
  ray.nu = 0.0;
  ray.length_ = way;
  ray.at_ground = false;
  ray.falls = false;
  return ray;
}
