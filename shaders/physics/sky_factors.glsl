// The light of a ray as smooth factors: single scattering of each medium without its phase function, and all the rest.
// The factors vary slowly over the sky where the phase functions do not, so they may be tabulated coarsely and the
// phase functions multiplied in at the pixel.
// The includer defines, for this file and shell_march.glsl:
//   real sun_share(Ray ray, real t, real width);  of the sun that terrain leaves, mean over a step; 1 without terrain

struct SkyFactors {
  vec3 single[kMaxMedia];  // 1/sr after multiplication by the medium's phase function
  vec3 diffuse;            // light scattered more than once, and the ground, W/(m2 sr)
  vec3 transmittance;      // of light whose scattering into a delta-scaled forward peak counts as none
  vec3 depth;              // optical depth, as this transmittance has it
  vec3 peaks;              // optical depth of those peaks
};

SkyFactors no_air() {
  SkyFactors factors;
  for (uint i = 0u; i < kMaxMedia; i++) {
    factors.single[i] = vec3(0.0);
  }
  factors.diffuse = vec3(0.0);
  factors.transmittance = vec3(1.0);
  factors.depth = vec3(0.0);
  factors.peaks = vec3(0.0);
  return factors;
}

// Of a beam of light, from which scattering takes whatever its angle.
vec3 beam_transmittance(SkyFactors factors) { return factors.transmittance * exp(-factors.peaks); }

vec3 phased(SkyFactors factors, Phases p) {
  vec3 sum = factors.diffuse;
  for (uint i = 0u; i < kMaxMedia; i++) {
    sum = sum + factors.single[i] * (i < medium_count() ? p.of[i] : vec3(0.0));
  }
  return sum;
}

// Of the air alone, the ground left out, along steps [first, last) of `steps`: what reaches the first one's near end.
SkyFactors air_factors_between(PlanetData planet, MomentTableData table, Ray ray, uint steps, uint first, uint last) {
  SkyFactors factors = no_air();
  Phases none = equal_phases(0.0);
  StepPlan plan = plan_steps(planet, ray, steps);
  uint end = ray.length_ > 0.0 ? last : first;
  for (uint i = first; i < end; i++) {
    Step s = planned_step(plan, i);
    RayPoint point = point_on_ray(planet, ray, s.t);
    real rise = s.width * point.mu;
    DiffuseAir air = diffuse_air_over(point.h, rise, none);
    vec3 step_depth = air.extinction * s.width;
    SegmentTransfer segment = segment_transfer(step_depth);
    vec3 weight = factors.transmittance * segment.mean * s.width;
    vec3 direct = weight * transmittance_to_sun(planet, point.h, point.mu_sun) * sun_share(ray, s.t, s.width);
    factors.single[0] = factors.single[0] + direct * medium_scattering(0u, point.h, rise);
    factors.single[1] = factors.single[1] + direct * medium_scattering(1u, point.h, rise);
    factors.single[2] = factors.single[2] + direct * medium_scattering(2u, point.h, rise);
    factors.single[3] = factors.single[3] + direct * medium_scattering(3u, point.h, rise);
    factors.single[4] = factors.single[4] + direct * medium_scattering(4u, point.h, rise);
    factors.single[5] = factors.single[5] + direct * medium_scattering(5u, point.h, rise);
    factors.single[6] = factors.single[6] + direct * medium_scattering(6u, point.h, rise);
    factors.single[7] = factors.single[7] + direct * medium_scattering(7u, point.h, rise);
    vec3 source = moment_source(table, air, point.h, point.mu_sun, point.mu, cos_azimuth_at(point, ray.nu));
    factors.diffuse = factors.diffuse + weight * source;
    factors.transmittance = factors.transmittance * segment.through;
    factors.depth = factors.depth + step_depth;
    factors.peaks = factors.peaks + air.peaks * s.width;
  }
  return factors;
}

SkyFactors air_factors(PlanetData planet, MomentTableData table, Ray ray, uint steps) {
  return air_factors_between(planet, table, ray, steps, 0u, steps);
}

// Of a ray's near part and the far part behind it.
SkyFactors joined(SkyFactors near, SkyFactors far) {
  for (uint i = 0u; i < kMaxMedia; i++) {
    near.single[i] = near.single[i] + near.transmittance * far.single[i];
  }
  near.diffuse = near.diffuse + near.transmittance * far.diffuse;
  near.transmittance = near.transmittance * far.transmittance;
  near.depth = near.depth + far.depth;
  near.peaks = near.peaks + far.peaks;
  return near;
}

// Light of the ground where the ray ends on it, seen through air of this transmittance, for a sun of irradiance 1.
vec3 ground_light(PlanetData planet, MomentTableData table, Ray ray, vec3 transmittance) {
  RayPoint end = point_on_ray(planet, ray, ray.length_);
  real facing = max(end.mu_sun, 0.0) * sun_share(ray, ray.length_, 0.0);
  vec3 irradiance = transmittance_to_sun(planet, 0.0, end.mu_sun) * facing +
                    moment_ground_irradiance(table, end.mu_sun);
  return transmittance * planet.ground_albedo * irradiance / kPi;
}

SkyFactors with_ground(PlanetData planet, MomentTableData table, Ray ray, SkyFactors factors) {
  if (ray.at_ground && ray.length_ >= 0.0) {
    factors.diffuse = factors.diffuse + ground_light(planet, table, ray, factors.transmittance);
  }
  return factors;
}

SkyFactors sky_factors(PlanetData planet, MomentTableData table, Ray ray, uint steps) {
  return with_ground(planet, table, ray, air_factors(planet, table, ray, steps));
}
