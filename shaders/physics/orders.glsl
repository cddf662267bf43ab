// Successive orders of scattering: the radiance of one order along one direction, from the one before.

// Light that the next order scatters into the ray, and the air that it meets there.
struct OrderSource {
  Stokes source;  // W/(m2 sr km) for a sun of irradiance 1; of sunlight `q` is what dipoles scatter, over their phase
  vec3 extinction;
};

// The sum with what the two nodes of a panel send, behind air of this transmittance.
Stokes with_nodes(Stokes sum, vec3 transmittance, Stokes near, Stokes far, PanelTransfer transfer) {
  sum.i = sum.i + transmittance * (near.i * transfer.near + far.i * transfer.far);
  if (polarised()) {
    sum.q = sum.q + transmittance * (near.q * transfer.near + far.q * transfer.far);
    sum.u = sum.u + transmittance * (near.u * transfer.near + far.u * transfer.far);
  }
  return sum;
}

// Sunlight that was scattered once: Q and U are the same shares of what dipoles scatter along the whole ray.
Stokes polarised_sunlight(Stokes sum, Ray ray) {
  RayPoint start;
  start.h = ray.h;
  start.mu = ray.mu;
  start.mu_sun = ray.mu_sun;
  real c = cos_azimuth_at(start, ray.nu);
  real s = sqrt(max(1.0 - ray.mu * ray.mu, 0.0));
  real sun = sqrt(max(1.0 - ray.mu_sun * ray.mu_sun, 0.0));
  real a = sun * ray.mu * c - ray.mu_sun * s;
  real b = -sun * sqrt(max(1.0 - c * c, 0.0));
  sum.u = sum.q * (-2.0 * a * b);
  sum.q = sum.q * (b * b - a * a);
  return sum;
}

OrderSource order_source(PlanetData planet, MomentTableData table, Ray ray, Phases p, real t, bool first) {
  RayPoint point = sunlit_point(planet, ray, t);
  DiffuseAir air = diffuse_air(densities_at(point.h), p);
  OrderSource lit;
  lit.source = no_light();
  if (first) {
    vec3 sunlight = transmittance_to_sun(planet, point.h, point.mu_sun);
    lit.source.i = sunlight * air.phase_scattering;
    lit.source.q = sunlight * air.dipoles;
  } else {
    real c = cos_azimuth_at(point, ray.nu);
    lit.source = moment_source(table, air, point, c, sine_of_azimuth(c));
  }
  lit.extinction = air.extinction;
  return lit;
}

// Light of order n at the ray's start; n = 1 (`first`): sunlight scattered once, or reflected by the ground; above:
// from the moments of order n - 1. For a sun of irradiance 1. Each panel has two Gauss-Legendre nodes.
Stokes order_radiance(PlanetData planet, MomentTableData table, Ray ray, uint panels, bool first) {
  ray = lit_ray(planet, ray);
  Phases p = gathered_phases(ray.nu);
  StepPlan plan = plan_steps(planet, ray, panels);
  Stokes radiance = no_light();
  vec3 transmittance = vec3(1.0);
  OrderSource near;
  near.source = no_light();
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
      radiance = with_nodes(radiance, transmittance, near.source, here.source, transfer);
      transmittance = transmittance * transfer.through;
    }
    near = here;
  }
  if (first && polarised()) {
    radiance = polarised_sunlight(radiance, ray);
  }
  if (ray.at_ground) {
    RayPoint end = sunlit_point(planet, ray, ray.length_);
    vec3 irradiance;
    if (first) {
      irradiance = transmittance_to_sun(planet, 0.0, end.mu_sun) * ground_facing(planet, end.mu_sun);
    } else {
      irradiance = moment_ground_irradiance(table, end.mu_sun);
    }
    radiance.i = radiance.i + transmittance * planet.ground_albedo * irradiance / kPi;
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
