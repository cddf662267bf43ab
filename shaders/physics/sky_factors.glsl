// The light of a ray as smooth factors: single scattering of each medium without its phase function, and all other
// light. The factors vary slowly over the sky, so that a table of them may be coarse; phase functions vary fast, and
// the pixel multiplies them in.
// The includer defines, for this file and shell_march.glsl:
//   real sun_share(Ray ray, real t, real width);  share of the sun past terrain or spheres, mean over a step
//   vec3 diffuse_share(Ray ray, real t);  share of the other light that the air there scatters among terrain
//   bool stokes();  whether Q and U are asked for (stokes.glsl)

struct SkyFactors {
  vec3 single[kMaxMedia];  // 1/sr after multiplication by the medium's phase function
  vec3 diffuse;            // light scattered more than once, and the ground, W/(m2 sr)
  vec3 q;                  // of this light, where it is asked for; by the meridian plane
  vec3 u;                  // likewise, over the sine that the azimuth from the sun's has where the sun is level
  vec3 transmittance;      // delta-scaled: scattering into the forward peak counts as none
  vec3 depth;              // optical depth of this transmittance
  vec3 peaks;              // optical depth of the forward peaks
};

SkyFactors no_air() {
  SkyFactors factors;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    factors.single[i] = vec3(0.0);
  }
  factors.diffuse = vec3(0.0);
  factors.q = vec3(0.0);
  factors.u = vec3(0.0);
  factors.transmittance = vec3(1.0);
  factors.depth = vec3(0.0);
  factors.peaks = vec3(0.0);
  return factors;
}

// Transmittance of a beam, from which scattering takes light whatever its angle.
vec3 beam_transmittance(SkyFactors factors) { return factors.transmittance * exp(-factors.peaks); }

vec3 phased(SkyFactors factors, Phases p) {
  vec3 sum = factors.diffuse;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    sum = sum + factors.single[i] * (i < medium_count() ? p.of[i] : vec3(0.0));
  }
  return sum;
}

// The light that is not sunlight scattered once, by axes_across(); u over the sine. `c`: cosine of the azimuth from the
// sun's at the camera. `mu_sun`: the sun's zenith cosine there.
Stokes diffuse_stokes(SkyFactors factors, real c, real mu_sun, bool upward) {
  Stokes light;
  light.i = factors.diffuse;
  light.q = factors.q;
  light.u = factors.u * sqrt(max(1.0 - mu_sun * mu_sun, 0.0));
  return by_sun_axes(light, c, upward);
}

// All light of a ray in direction d, by axes_across().
Stokes stokes_along(SkyFactors factors, Phases p, vec3 d, vec3 sun) {
  vec3 dipoles = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    dipoles = dipoles + (is_molecular(i) ? factors.single[i] * dipole_share(i) * kDipole : vec3(0.0));
  }
  Stokes light = diffuse_stokes(factors, azimuth_from_sun(d, sun).x, sun.y, d.y >= 0.0);
  light.i = phased(factors, p);
  return with_sunlight(light, dipoles, d, sun);
}

// Light scattered into the ray at a node of a panel, and the air there.
struct NodeLight {
  vec3 single[kMaxMedia];  // 1/km, of each medium, without its phase function
  Stokes diffuse;          // W/(m2 sr km); its u as that of the factors
  vec3 extinction;
  vec3 peaks;
};

// A straight ray leaves the vertical plane of its heading nowhere, so the sun's part across that plane is the same at
// all of its points. U is proportional to this part: to the sine of the azimuth times the sine of the sun's zenith angle.
real sine_over_sun(RayPoint point) { return 1.0 / max(sqrt(max(1.0 - point.mu_sun * point.mu_sun, 0.0)), 1e-3); }

SkyFactors with_polarised(SkyFactors factors, vec3 share, Stokes light) {
  if (stokes()) {
    factors.q = factors.q + share * light.q;
    factors.u = factors.u + share * light.u;
  }
  return factors;
}

Stokes dimmed(Stokes light, vec3 share) {
  light.i = light.i * share;
  light.q = light.q * share;
  light.u = light.u * share;
  return light;
}

// `share`: the part of the sun that reaches the node.
NodeLight node_light(PlanetData planet, MomentTableData table, Ray ray, real t, real share) {
  RayPoint point = sunlit_point(planet, ray, t);
  DiffuseAir air = diffuse_air(densities_at(point.h), equal_phases(0.0));
  vec3 direct = transmittance_to_sun(planet, point.h, point.mu_sun) * share;
  NodeLight light;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    light.single[i] = direct * medium_scattering(i, point.h, 0.0);
  }
  light.diffuse = dimmed(moment_source(table, air, point, cos_azimuth_at(point, ray.nu), sine_over_sun(point)),
                         diffuse_share(ray, t));
  light.extinction = air.extinction;
  light.peaks = air.peaks;
  return light;
}

SkyFactors with_panel_light(SkyFactors factors, NodeLight near, NodeLight far, real width) {
  PanelTransfer transfer = panel_transfer(near.extinction, far.extinction, width);
  vec3 a = factors.transmittance * transfer.near;
  vec3 b = factors.transmittance * transfer.far;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    factors.single[i] = factors.single[i] + a * near.single[i] + b * far.single[i];
  }
  factors.diffuse = factors.diffuse + a * near.diffuse.i + b * far.diffuse.i;
  factors = with_polarised(with_polarised(factors, a, near.diffuse), b, far.diffuse);
  factors.transmittance = factors.transmittance * transfer.through;
  factors.depth = factors.depth + transfer.depth;
  factors.peaks = factors.peaks + (near.peaks + far.peaks) * (0.5 * width);
  return factors;
}

// Factors of the air without the ground along panels [first, last) of `panels`, as they reach the near end of panel
// `first`. It goes node by node, as order_radiance() does.
SkyFactors air_factors_between(PlanetData planet, MomentTableData table, Ray ray, uint panels, uint first, uint last) {
  ray = lit_ray(planet, ray);
  SkyFactors factors = no_air();
  StepPlan plan = plan_steps(planet, ray, panels);
  NodeLight near;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    near.single[i] = vec3(0.0);
  }
  near.diffuse = no_light();
  near.extinction = vec3(0.0);
  near.peaks = vec3(0.0);
  uint end = ray.length_ > 0.0 ? 2u * last : 2u * first;
  for (uint i = 2u * first; i < end; i++) {
    Step panel = planned_step(plan, i / 2u);
    bool second = (i & 1u) != 0u;
    real side = second ? 1.0 : -1.0;
    real share = sun_share(ray, panel.t + side * 0.25 * panel.width, 0.5 * panel.width);
    NodeLight here = node_light(planet, table, ray, panel.t + side * kPanelNode * panel.width, share);
    if (second) {
      factors = with_panel_light(factors, near, here, panel.width);
    }
    near = here;
  }
  return factors;
}

// Two Gauss-Legendre nodes a panel: an odd number of steps is rounded up.
SkyFactors air_factors(PlanetData planet, MomentTableData table, Ray ray, uint steps) {
  uint panels = (steps + 1u) / 2u;
  return air_factors_between(planet, table, ray, panels, 0u, panels);
}

// Factors of a ray's near part and the far part behind it.
SkyFactors joined(SkyFactors near, SkyFactors far) {
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    near.single[i] = near.single[i] + near.transmittance * far.single[i];
  }
  near.diffuse = near.diffuse + near.transmittance * far.diffuse;
  near.q = near.q + near.transmittance * far.q;
  near.u = near.u + near.transmittance * far.u;
  near.transmittance = near.transmittance * far.transmittance;
  near.depth = near.depth + far.depth;
  near.peaks = near.peaks + far.peaks;
  return near;
}

// Light of the ground at the ray's end, seen through air of this transmittance, for a sun of irradiance 1.
vec3 ground_light(PlanetData planet, MomentTableData table, Ray ray, vec3 transmittance) {
  RayPoint end = sunlit_point(planet, lit_ray(planet, ray), ray.length_);
  real facing = ground_facing(planet, end.mu_sun) * sun_share(ray, ray.length_, 0.0);
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

// The part of a ray from one distance to another as a ray of its own.
Ray part_of_ray(PlanetData planet, Ray ray, real from, real to) {
  RayPoint point = point_on_ray(planet, ray, from);
  Ray part = ray;
  if (bends_light()) {
    real bent = bending_ahead(planet, ray.falls, ray.h, ray.mu) - bending_ahead(planet, ray.falls, point.h, point.mu);
    part.nu = turned_cosine(point, ray, bent);
    point = with_turned_sun(point, ray, bent);
  }
  part.h = point.h;
  part.mu = point.mu;
  part.mu_sun = point.mu_sun;
  part.length_ = to - from;
  return part;
}
