// The planet's shadow along a ray.

// Distances at which the planet's shadow begins or ends along a ray, in order; a crossing that does not exist lies
// outside 0 to length_. The shadow is the half cylinder of the planet's radius behind it.
struct ShadowCrossings {
  real first;
  real second;
};

real night_crossing(PlanetData planet, Ray ray, real t) {
  bool night = (planet.ground_radius + ray.h) * ray.mu_sun + t * ray.nu < 0.0;
  return night && t > 0.0 && t < ray.length_ ? t : ray.length_;
}

ShadowCrossings shadow_crossings(PlanetData planet, Ray ray) {
  real r = planet.ground_radius + ray.h;
  real a = max(1.0 - ray.nu * ray.nu, 1e-12);
  real b = r * (ray.mu - ray.mu_sun * ray.nu);
  real c = ray.h * (2.0 * planet.ground_radius + ray.h) - r * r * ray.mu_sun * ray.mu_sun;
  real discriminant = b * b - a * c;
  ShadowCrossings s;
  s.first = ray.length_;
  s.second = ray.length_;
  if (discriminant > 0.0) {
    real root = sqrt(discriminant);
    real q = b > 0.0 ? -(b + root) : root - b;
    real t1 = night_crossing(planet, ray, q / a);
    real t2 = night_crossing(planet, ray, abs(q) > 0.0 ? c / q : ray.length_);
    s.first = min(t1, t2);
    s.second = max(t1, t2);
  }
  return s;
}
