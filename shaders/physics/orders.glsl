// Successive orders of scattering: the radiance of one order along one direction, from the one before.

// Radiance of order n at the ray's start; n = 1 (`first`): sunlight scattered once, or reflected by the ground; above:
// from the moments of order n - 1. For a sun of irradiance 1.
vec3 order_radiance(PlanetData planet, MomentTableData table, Ray ray, uint steps, bool first) {
  Phases p = gathered_phases(ray.nu);
  real falling = -(planet.ground_radius + ray.h) * ray.mu;
  uint before = falling_steps(falling, ray.length_, steps);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(1.0);
  uint count = ray.length_ > 0.0 ? steps : 0u;
  real start = 0.0;
  for (uint i = 0u; i < count; i++) {
    real end = step_end(kStepsQuadratic, falling, ray.length_, before, i, steps);
    Step s = step_between(start, end);
    start = end;
    RayPoint point = point_on_ray(planet, ray, s.t);
    DiffuseAir air = diffuse_air_over(point.h, s.width * point.mu, p);
    vec3 source;
    if (first) {
      source = transmittance_to_sun(planet, point.h, point.mu_sun) * air.phase_scattering;
    } else {
      source = moment_source(table, air, point.h, point.mu_sun, point.mu, cos_azimuth_at(point, ray.nu));
    }
    vec3 step_depth = air.extinction * s.width;
    SegmentTransfer segment = segment_transfer(step_depth);
    radiance = radiance + transmittance * segment.mean * source * s.width;
    transmittance = transmittance * segment.through;
  }
  if (ray.at_ground) {
    RayPoint end = point_on_ray(planet, ray, ray.length_);
    vec3 irradiance;
    if (first) {
      irradiance = transmittance_to_sun(planet, 0.0, end.mu_sun) * max(end.mu_sun, 0.0);
    } else {
      irradiance = moment_ground_irradiance(table, end.mu_sun);
    }
    radiance = radiance + transmittance * planet.ground_albedo * irradiance / kPi;
  }
  return radiance;
}

// Zenith cosine of quadrature node z in 0 to 1, measured from the true horizon at altitude h: no interval straddles it.
real gather_mu(PlanetData planet, real h, real z, bool upward) {
  real horizon = horizon_mu(planet, h);
  return upward ? horizon + (1.0 - horizon) * z : horizon - (1.0 + horizon) * z;
}

real gather_range(PlanetData planet, real h, bool upward) {
  real horizon = horizon_mu(planet, h);
  return upward ? 1.0 - horizon : 1.0 + horizon;
}
