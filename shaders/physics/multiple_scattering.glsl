// Orders of scattering from the second up as isotropic light [H20 sec. 5.5.1].

// Contribution of one direction of the sphere at a point.
struct ScatteringGather {
  vec3 second_order;  // radiance that arrives after one scattering event or the ground, isotropic phase there, 1/sr
  // The part of a unit isotropic field that arrives along this direction. It includes the ground's reflection: without
  // it the sky over albedo 0.3 is 4.6 % too dark on average, with it 2.0 %.
  vec3 transfer;
};

// Direction k of 8 x 8, each the middle of an equal part of the sphere.
Ray gather_ray(PlanetData planet, real h, real mu_sun, uint k) {
  real mu = 1.0 - 2.0 * (real(k / 8u) + 0.5) / 8.0;
  real azimuth = 2.0 * kPi * (real(k % 8u) + 0.5) / 8.0;
  real nu = mu * mu_sun + sqrt(max((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun), 0.0)) * cos(azimuth);
  return ray_in_atmosphere(planet, h, mu, mu_sun, nu);
}

ScatteringGather gather_scattering(PlanetData planet, SunData sun, Ray ray, uint steps) {
  ray = lit_ray(planet, ray);
  ScatteringGather gather;
  gather.second_order = vec3(0.0);
  gather.transfer = vec3(0.0);
  Phases isotropic = equal_phases(phase_isotropic());
  real falling = -(planet.ground_radius + ray.h) * ray.mu;
  uint before = falling_steps(falling, ray.length_, steps);
  vec3 transmittance = vec3(1.0);
  uint count = ray.length_ > 0.0 ? steps : 0u;
  real start = 0.0;
  for (uint i = 0u; i < count; i++) {
    real end = step_end(kStepsQuadratic, falling, ray.length_, before, i, steps);
    Step s = step_between(start, end);
    start = end;
    RayPoint point = sunlit_point(planet, ray, s.t);
    Air air = air_at(point.h, isotropic);
    vec3 step_depth = air.extinction * s.width;
    SegmentTransfer segment = segment_transfer(step_depth);
    vec3 weight = transmittance * segment.mean * s.width;
    vec3 direct = transmittance_to_sun(planet, point.h, point.mu_sun) * sun_fade(sun, point.mu_sun);
    gather.second_order = gather.second_order + weight * air.phase_scattering * direct;
    gather.transfer = gather.transfer + weight * air.scattering;
    transmittance = transmittance * segment.through;
  }
  if (ray.at_ground) {
    RayPoint end = sunlit_point(planet, ray, ray.length_);
    vec3 direct = transmittance_to_sun(planet, 0.0, end.mu_sun) * (ground_facing(planet, end.mu_sun) * sun_fade(sun, end.mu_sun));
    gather.second_order = gather.second_order + transmittance * planet.ground_albedo * direct / kPi;
    gather.transfer = gather.transfer + transmittance * planet.ground_albedo;
  }
  return gather;
}

// All orders from the mean over directions of second order and transfer: a geometric series [H20 eq. 9]. In thick air
// without absorption the transfer nears 1; the sum is limited to a thousand orders.
vec3 sum_of_orders(vec3 second_order, vec3 transfer) {
  return second_order / max(vec3(1.0) - transfer, vec3(1e-3));
}
