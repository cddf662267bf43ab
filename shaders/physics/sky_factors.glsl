// The light of a ray as smooth factors: single scattering of each medium without its phase function, and all the rest.
// The factors vary slowly over the sky where the phase functions do not, so they may be tabulated coarsely and the
// phase functions multiplied in at the pixel.

struct SkyFactors {
  vec3 single[kMaxMedia];  // 1/sr after multiplication by the medium's phase function
  vec3 diffuse;            // light scattered more than once, and the ground, W/(m2 sr)
  vec3 transmittance;
};

vec3 phased(SkyFactors factors, Phases p) {
  vec3 sum = factors.diffuse;
  for (uint i = 0u; i < kMaxMedia; i++) {
    sum = sum + factors.single[i] * (i < medium_count() ? p.of[i] : 0.0);
  }
  return sum;
}

// Steps uniform in s = +-sqrt(distance from the lowest point), apart on up to three intervals that no shadow's edge and
// no lowest point lies inside.
struct StepPlan {
  real lowest;  // distance of the ray's lowest point
  real s0;      // ends of the intervals
  real s1;
  real s2;
  real s3;
  uint n1;  // steps up to s1
  uint n2;  // steps up to s2
  uint n;
};

real path_coordinate(real lowest, real t) { return t < lowest ? -sqrt(lowest - t) : sqrt(t - lowest); }

real path_distance(real lowest, real s) { return lowest + (s < 0.0 ? -s * s : s * s); }

StepPlan plan_steps(PlanetData planet, Ray ray, uint n) {
  ShadowCrossings shadow = shadow_crossings(planet, ray);
  StepPlan plan;
  plan.lowest = clamp(-(planet.ground_radius + ray.h) * ray.mu, 0.0, ray.length_);
  real first = shadow.first;
  real second = shadow.second;
  // A lowest point inside takes the place of a crossing that is not there.
  if (second >= ray.length_ && plan.lowest > 0.0 && plan.lowest < ray.length_) {
    second = max(first, plan.lowest);
    first = min(first, plan.lowest);
  }
  plan.s0 = path_coordinate(plan.lowest, 0.0);
  plan.s1 = path_coordinate(plan.lowest, first);
  plan.s2 = path_coordinate(plan.lowest, second);
  plan.s3 = path_coordinate(plan.lowest, ray.length_);
  real scale = real(n) / max(plan.s3 - plan.s0, 1e-12);
  plan.n = n;
  plan.n1 = uint(clamp(floor((plan.s1 - plan.s0) * scale + 0.5), 1.0, real(n)));
  plan.n2 = uint(clamp(floor((plan.s2 - plan.s0) * scale + 0.5), min(real(plan.n1) + 1.0, real(n)), real(n)));
  // The last interval, where there is one, gets a step.
  if (plan.s3 > plan.s2 && plan.n2 == n && n >= 3u) {
    plan.n2 = n - 1u;
    plan.n1 = min(plan.n1, n - 2u);
  }
  return plan;
}

Step planned_step(StepPlan plan, uint i) {
  bool one = i < plan.n1;
  bool two = i < plan.n2;
  real low = one ? plan.s0 : two ? plan.s1 : plan.s2;
  real high = one ? plan.s1 : two ? plan.s2 : plan.s3;
  real from = real(one ? 0u : two ? plan.n1 : plan.n2);
  real to = real(one ? plan.n1 : two ? plan.n2 : plan.n);
  real width = (high - low) / max(to - from, 1.0);
  real a = path_distance(plan.lowest, low + (real(i) - from) * width);
  real b = path_distance(plan.lowest, low + (real(i) - from + 1.0) * width);
  Step s;
  s.t = 0.5 * (a + b);
  s.width = b - a;
  return s;
}

// Of the air alone: the ground, where the ray ends on it, is left out.
SkyFactors air_factors(PlanetData planet, MomentTableData table, Ray ray, uint steps) {
  SkyFactors factors;
  for (uint i = 0u; i < kMaxMedia; i++) {
    factors.single[i] = vec3(0.0);
  }
  factors.diffuse = vec3(0.0);
  factors.transmittance = vec3(1.0);
  Phases none = equal_phases(0.0);
  StepPlan plan = plan_steps(planet, ray, steps);
  uint count = ray.length_ > 0.0 ? steps : 0u;
  for (uint i = 0u; i < count; i++) {
    Step s = planned_step(plan, i);
    RayPoint point = point_on_ray(planet, ray, s.t);
    DiffuseAir air = diffuse_air_at(point.h, none);
    vec3 step_depth = air.extinction * s.width;
    SegmentTransfer segment = segment_transfer(step_depth);
    vec3 weight = factors.transmittance * segment.mean * s.width;
    vec3 direct = weight * transmittance_to_sun(planet, point.h, point.mu_sun);
    factors.single[0] = factors.single[0] + direct * medium_scattering(0u, point.h);
    factors.single[1] = factors.single[1] + direct * medium_scattering(1u, point.h);
    factors.single[2] = factors.single[2] + direct * medium_scattering(2u, point.h);
    factors.single[3] = factors.single[3] + direct * medium_scattering(3u, point.h);
    factors.single[4] = factors.single[4] + direct * medium_scattering(4u, point.h);
    factors.single[5] = factors.single[5] + direct * medium_scattering(5u, point.h);
    factors.single[6] = factors.single[6] + direct * medium_scattering(6u, point.h);
    factors.single[7] = factors.single[7] + direct * medium_scattering(7u, point.h);
    vec3 source = moment_source(table, air, point.h, point.mu_sun, point.mu, cos_azimuth_at(point, ray.nu));
    factors.diffuse = factors.diffuse + weight * source;
    factors.transmittance = factors.transmittance * segment.through;
  }
  return factors;
}

// Light of the ground where the ray ends on it, seen through air of this transmittance, for a sun of irradiance 1.
vec3 ground_light(PlanetData planet, MomentTableData table, Ray ray, vec3 transmittance) {
  RayPoint end = point_on_ray(planet, ray, ray.length_);
  vec3 irradiance = transmittance_to_sun(planet, 0.0, end.mu_sun) * max(end.mu_sun, 0.0) +
                    moment_ground_irradiance(table, end.mu_sun);
  return transmittance * planet.ground_albedo * irradiance / kPi;
}

SkyFactors sky_factors(PlanetData planet, MomentTableData table, Ray ray, uint steps) {
  SkyFactors factors = air_factors(planet, table, ray, steps);
  if (ray.at_ground && ray.length_ >= 0.0) {
    factors.diffuse = factors.diffuse + ground_light(planet, table, ray, factors.transmittance);
  }
  return factors;
}
