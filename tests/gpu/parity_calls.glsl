// The functions of shaders/physics behind one signature, for parity_test.cpp: GLSL in parity_functions.comp, C++ on
// double in the test.

struct Arguments {
  real a;
  real b;
  real c;
  real d;
  real e;
  real f;
};
struct Results {
  real a;
  real b;
  real c;
  real d;
  real e;
  real f;
};

Results results_of(real a, real b, real c, real d, real e, real f) {
  Results r;
  r.a = a;
  r.b = b;
  r.c = c;
  r.d = d;
  r.e = e;
  r.f = f;
  return r;
}

real flag(bool value) { return value ? 1.0 : 0.0; }

Results call_geometry(uint function, Arguments x) {
  PlanetData planet = scene.planet;
  if (function == kCallHorizon) {
    return results_of(horizon_distance(planet, x.a), horizon_mu(planet, x.a), 0.0, 0.0, 0.0, 0.0);
  }
  if (function == kCallDistances) {
    bool meets = meets_ground(planet, x.a, x.b);
    return results_of(distance_to_top(planet, x.a, x.b), meets ? distance_to_ground(planet, x.a, x.b) : -1.0,
                      flag(meets), 0.0, 0.0, 0.0);
  }
  if (function == kCallRay) {
    Ray ray = ray_in_atmosphere(planet, x.a, x.b, x.c, x.d);
    return results_of(ray.h, ray.mu, ray.mu_sun, ray.nu, ray.length_, flag(ray.at_ground));
  }
  Ray ray;
  ray.h = x.a;
  ray.mu = x.b;
  ray.mu_sun = x.c;
  ray.nu = x.d;
  ray.length_ = x.e;
  ray.at_ground = false;
  ray.falls = false;
  RayPoint point = point_on_ray(planet, ray, x.e);
  return results_of(point.h, point.mu, point.mu_sun, 0.0, 0.0, 0.0);
}

Results call_table(uint function, Arguments x) {
  PlanetData planet = scene.planet;
  if (function == kCallTransmittanceCoordinate) {
    TransmittanceCoordinate c = transmittance_coordinate(planet, x.a, x.b);
    return results_of(c.x, c.y, 0.0, 0.0, 0.0, 0.0);
  }
  if (function == kCallTransmittanceState) {
    TransmittanceState s = transmittance_state(planet, x.a, x.b);
    TransmittanceCoordinate c = transmittance_coordinate(planet, s.h, s.mu);
    return results_of(s.h, s.mu, c.x, c.y, 0.0, 0.0);
  }
  ScatteringCoordinate c = scattering_coordinate(planet, x.a, x.b);
  ScatteringState s = scattering_state(planet, c.x, c.y);
  return results_of(c.x, c.y, s.h, s.mu_sun, 0.0, 0.0);
}

Results call_air(uint function, Arguments x) {
  if (function == kCallPhase) {
    return results_of(phase_value(uint(x.a), x.b, x.c), 0.0, 0.0, 0.0, 0.0, 0.0);
  }
  if (function == kCallAir) {
    Air air = air_at(x.a, phases(x.b));
    vec3 e = air.extinction;
    vec3 s = air.phase_scattering;
    return results_of(e.x, e.y, e.z, s.x, s.y, s.z);
  }
  vec3 depth = optical_depth_to_top(scene.planet, x.a, x.b, uint(x.c));
  return results_of(depth.x, depth.y, depth.z, 0.0, 0.0, 0.0);
}

Results call_step(uint function, Arguments x) {
  if (function == kCallSegment) {
    return results_of(mean_transmittance(x.a), 0.0, 0.0, 0.0, 0.0, 0.0);
  }
  uint n = uint(x.e);
  uint before = falling_steps(x.b, x.c, n);
  Step s = ray_step(uint(x.a), x.b, x.c, before, uint(x.d), n);
  return results_of(s.t, s.width, real(before), 0.0, 0.0, 0.0);
}

Results call(uint function, Arguments x) {
  if (function <= kCallPoint) {
    return call_geometry(function, x);
  }
  if (function == kCallPhase || function == kCallAir || function == kCallDepth) {
    return call_air(function, x);
  }
  if (function == kCallSegment || function == kCallStep) {
    return call_step(function, x);
  }
  if (function <= kCallScattering) {
    return call_table(function, x);
  }
  if (function == kCallDisc) {
    return results_of(disc_profile(scene.sun, x.a), sun_fade(scene.sun, x.b), 0.0, 0.0, 0.0, 0.0);
  }
  ViewRay ray = view_ray(scene.camera, function - kCallViewRay, x.a, x.b);
  return results_of(ray.direction.x, ray.direction.y, ray.direction.z, flag(ray.inside), 0.0, 0.0);
}
