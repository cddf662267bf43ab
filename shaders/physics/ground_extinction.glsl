// The extinction between camera and ground as `orders` has it: with delta_scaled(), without what the peaks of phase
// functions scatter.

// Optical depth over length. Steps are dense toward the ground.
vec3 mean_extinction(PlanetData planet, Ray ray) {
  const uint kSteps = 512u;
  Phases none = equal_phases(0.0);
  vec3 depth = vec3(0.0);
  real start = 0.0;
  for (uint i = 0u; i < kSteps; i++) {
    real end = step_end(kStepsQuadratic, 0.0, ray.length_, 0u, i, kSteps);
    Step s = step_between(start, end);
    start = end;
    RayPoint point = point_on_ray(planet, ray, s.t);
    depth = depth + diffuse_air(stretch_densities(stretch_of(planet, point, s.width)), none).extinction * s.width;
  }
  return depth / ray.length_;
}
