// Successive orders of scattering: the radiance of one order along one direction, from the one before.

// Light that the next order scatters into the ray, and the air that it meets there.
struct OrderSource {
  vec3 source;  // W/(m2 sr km) for a sun of irradiance 1
  vec3 extinction;
};

OrderSource order_source(PlanetData planet, MomentTableData table, Ray ray, Phases p, real t, bool first) {
  RayPoint point = point_on_ray(planet, ray, t);
  DiffuseAir air = diffuse_air(densities_at(point.h), p);
  OrderSource lit;
  if (first) {
    lit.source = transmittance_to_sun(planet, point.h, point.mu_sun) * air.phase_scattering;
  } else {
    lit.source = moment_source(table, air, point.h, point.mu_sun, point.mu, cos_azimuth_at(point, ray.nu));
  }
  lit.extinction = air.extinction;
  return lit;
}

// Radiance of order n at the ray's start; n = 1 (`first`): sunlight scattered once, or reflected by the ground; above:
// from the moments of order n - 1. For a sun of irradiance 1. Each panel has two Gauss-Legendre nodes.
vec3 order_radiance(PlanetData planet, MomentTableData table, Ray ray, uint panels, bool first) {
  Phases p = gathered_phases(ray.nu);
  StepPlan plan = plan_steps(planet, ray, panels);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(1.0);
  OrderSource near;
  near.source = vec3(0.0);
  near.extinction = vec3(0.0);
  // Node by node, so that the code of one stands once: pipelines are made in half the time.
  uint count = ray.length_ > 0.0 ? 2u * panels : 0u;
  for (uint i = 0u; i < count; i++) {
    Step panel = planned_step(plan, i / 2u);
    bool second = (i & 1u) != 0u;
    real offset = second ? kPanelNode : -kPanelNode;
    OrderSource here = order_source(planet, table, ray, p, panel.t + offset * panel.width, first);
    if (second) {
      PanelTransfer transfer = panel_transfer(near.extinction, here.extinction, panel.width);
      radiance = radiance + transmittance * (near.source * transfer.near + here.source * transfer.far);
      transmittance = transmittance * transfer.through;
    }
    near = here;
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
