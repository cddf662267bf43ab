// The rays of `orders` through shells (shells.glsl). The two integrals are those of order_radiance() and sky_factors(),
// with steps from edge to edge and sunlight that falls exponentially within a step. The diffuse source is taken at the
// point of the step that its light comes from on average.
// The includer defines, beside what the moments ask for:
//   vec3 fetch_sun_table(real x, real y);  mean extinction toward the sun; x: sun_table_coordinate(), y: row, 0 to 1

// Optical depth toward the sun, as if the ground were not in the way; `row`: shell_coordinate() of h.
vec3 sun_depth(PlanetData planet, real h, real row, real mu_sun) {
  real mu = max(lifted_sun(h, mu_sun), horizon_mu(planet, h));
  return fetch_sun_table(sun_table_coordinate(planet, h, mu), row) * distance_to_top(planet, h, mu);
}

// Irradiance of level ground by the sun itself, for a sun of irradiance 1.
vec3 shell_sun_irradiance(PlanetData planet, real mu_sun) {
  real facing = ground_facing(planet, mu_sun);
  return facing > 0.0 ? exp(-sun_depth(planet, 0.0, 0.0, mu_sun)) * facing : vec3(0.0);
}

// Interpolates between two rows whose logarithms are a and b. Deep in even air a diffuse field is linear, and in air
// without absorption each order repeats the error of the one before, so the result is linear. Below a low sun the field
// falls steeply, so there the result is exponential. `bend`: see bend_between().
vec3 between_rows(vec3 a, vec3 b, real part, vec3 bend) {
  vec3 low = exp(a);
  vec3 high = exp(b);
  vec3 q = (b - a) * (b - a) * (1.0 / 0.09);
  vec3 steep = q * q / (q * q + vec3(1.0));
  vec3 even = low * (1.0 - part) + high * part - bend * (part * (1.0 - part));
  return even + (exp(a * (1.0 - part) + b * part) - even) * steep;
}

// Returns the number nearer to 0 where both have the same sign, else 0.
real lesser(real a, real b) { return a * b <= 0.0 ? 0.0 : (a < 0.0 ? max(a, b) : min(a, b)); }

// Returns how far the isotropic moment bends away from the straight line between two rows: half its second difference
// over the shell. The shells below and above yield one value each. The two differ where the air has an edge; the lesser
// is returned. Next to the air's ends a diffuse field bulges up; a straight line loses the bulge, in each order anew.
// The bend is limited to a quarter of the two rows' sum: a thick shell at an optical depth of 178, between much thinner
// ones, got so much more than its rows hold that orders grew.
vec3 bend_between(uint shell, real x, vec3 low, vec3 high) {
  real intervals = real(shell_rows() - 1u);
  real width = shell_altitude(shell + 1u) - shell_altitude(shell);
  vec3 rise = high - low;
  vec3 below = vec3(0.0);
  vec3 above = vec3(0.0);
  bool has_below = shell > 0u;
  bool has_above = shell + 2u < shell_rows();
  if (has_below) {
    real under = shell_altitude(shell) - shell_altitude(shell - 1u);
    vec3 lower = exp(fetch_moment(0u, x, real(shell - 1u) / intervals));
    below = (rise - (low - lower) * (width / under)) * (width / (width + under));
  }
  if (has_above) {
    real over = shell_altitude(shell + 2u) - shell_altitude(shell + 1u);
    vec3 higher = exp(fetch_moment(0u, x, real(shell + 2u) / intervals));
    above = ((higher - high) * (width / over) - rise) * (width / (width + over));
  }
  if (!has_below) {
    below = above;
  }
  if (!has_above) {
    above = below;
  }
  vec3 most = 0.25 * (low + high);
  vec3 bend = vec3(lesser(below.x, above.x), lesser(below.y, above.y), lesser(below.z, above.z));
  return max(min(bend, most), vec3(0.0) - most);
}

// Light scattered into the ray by the diffuse field, W/(m2 sr km), at a point in a known shell. Each row's ratios of
// moments are weighed by the row's isotropic moment. `sine`: as of moment_source_of().
Stokes shell_source(MomentTableData table, DiffuseAir air, uint shell, RayPoint point, real cos_azimuth, real sine) {
  MomentCoordinate c = moment_coordinate(table, point.h, point.mu_sun);
  real intervals = real(shell_rows() - 1u);
  real part = shell_part(shell, point.h);
  vec3 below = fetch_moment(0u, c.x, real(shell) / intervals);
  vec3 above = fetch_moment(0u, c.x, real(shell + 1u) / intervals);
  vec3 isotropic = between_rows(below, above, part, bend_between(shell, c.x, exp(below), exp(above)));
  real step_up = (above.x + above.y + above.z - below.x - below.y - below.z) / 3.0;
  real weight = part / (part + (1.0 - part) * exp(-clamp(step_up, -20.0, 20.0)));
  c.y = (real(shell) + weight) / intervals;
  return moment_source_of(isotropic, c, air, point.mu, cos_azimuth, sine);
}

vec3 sun_depth_on_ray(PlanetData planet, Ray ray, uint shell, real t) {
  RayPoint point = sunlit_point(planet, ray, t);
  return sun_depth(planet, point.h, shell_coordinate(shell, point.h), point.mu_sun);
}

// order_radiance() through shells; `parts`: steps in each shell.
Stokes shell_order_radiance(PlanetData planet, MomentTableData table, Ray ray, uint parts, bool first) {
  ray = lit_ray(planet, ray);
  Phases p = gathered_phases(ray.nu);
  ShadowCrossings shadow = shadow_crossings(planet, ray);
  ShellWalk walk = shell_walk(planet, ray);
  Stokes radiance = no_light();
  vec3 transmittance = vec3(1.0);
  vec3 near = first ? sun_depth_on_ray(planet, ray, walk.shell, 0.0) : vec3(0.0);
  vec3 behind = vec3(0.0);  // radiance of endless even air with the last step's source
  bool deep = false;
  uint count = most_steps(parts);
  for (uint i = 0u; i < count; i++) {
    walk = next_step(walk, planet, ray, shadow, parts);
    deep = max(transmittance.x, max(transmittance.y, transmittance.z)) < 1e-4;
    if (walk.done || deep) {
      break;
    }
    real width = walk.to - walk.from;
    RayPoint point = sunlit_point(planet, ray, walk.from + 0.5 * width);
    DiffuseAir air = diffuse_air(stretch_densities(stretch_of(planet, point, width)), p);
    vec3 step_depth = air.extinction * width;
    SegmentTransfer segment = segment_transfer(step_depth);
    if (first) {
      vec3 far = sun_depth_on_ray(planet, ray, walk.shell, walk.to);
      if (sun_is_up(planet, point.h, point.mu_sun)) {
        vec3 sunlight = transmittance * mean_sunlight3(near, far, step_depth);
        radiance.i = radiance.i + sunlight * air.phase_scattering * width;
        radiance.q = radiance.q + sunlight * air.dipoles * width;
      }
      near = far;
    } else {
      real place = walk.from + width * source_place((step_depth.x + step_depth.y + step_depth.z) / 3.0);
      RayPoint at = sunlit_point(planet, ray, place);
      real c = cos_azimuth_at(at, ray.nu);
      Stokes source = shell_source(table, air, walk.shell, at, c, sine_of_azimuth(c));
      radiance.i = radiance.i + transmittance * segment.mean * source.i * width;
      if (polarised()) {
        radiance.q = radiance.q + transmittance * segment.mean * source.q * width;
        radiance.u = radiance.u + transmittance * segment.mean * source.u * width;
      }
      behind = source.i / max(air.extinction, vec3(1e-30));
    }
    transmittance = transmittance * segment.through;
  }
  if (first && polarised()) {
    radiance = polarised_sunlight(radiance, ray);
  }
  if (deep) {
    // Deep air loses light at its ends alone: a ten-thousandth lost by each order would count.
    radiance.i = radiance.i + transmittance * behind;
  } else if (ray.at_ground) {
    RayPoint end = sunlit_point(planet, ray, ray.length_);
    vec3 irradiance;
    if (first) {
      irradiance = shell_sun_irradiance(planet, end.mu_sun);
    } else {
      irradiance = moment_ground_irradiance(table, end.mu_sun);
    }
    radiance.i = radiance.i + transmittance * planet.ground_albedo * irradiance / kPi;
  }
  return radiance;
}

// air_factors() for air cut into shells.
SkyFactors shell_air_factors(PlanetData planet, MomentTableData table, Ray ray, uint parts) {
  ray = lit_ray(planet, ray);
  SkyFactors factors = no_air();
  Phases none = equal_phases(0.0);
  ShadowCrossings shadow = shadow_crossings(planet, ray);
  ShellWalk walk = shell_walk(planet, ray);
  vec3 near = sun_depth_on_ray(planet, ray, walk.shell, 0.0);
  uint count = most_steps(parts);
  for (uint i = 0u; i < count; i++) {
    walk = next_step(walk, planet, ray, shadow, parts);
    if (walk.done) {
      break;
    }
    real width = walk.to - walk.from;
    RayPoint point = sunlit_point(planet, ray, walk.from + 0.5 * width);
    Densities densities = stretch_densities(stretch_of(planet, point, width));
    DiffuseAir air = diffuse_air(densities, none);
    vec3 step_depth = air.extinction * width;
    SegmentTransfer segment = segment_transfer(step_depth);
    vec3 far = sun_depth_on_ray(planet, ray, walk.shell, walk.to);
    real lit = sun_is_up(planet, point.h, point.mu_sun) ? 1.0 : 0.0;
    vec3 direct = factors.transmittance * mean_sunlight3(near, far, step_depth) *
                  (width * lit * sun_share(ray, walk.from + 0.5 * width, width));
    near = far;
    UNROLL for (uint m = 0u; m < kMaxMedia; m++) {
      factors.single[m] = factors.single[m] + direct * scattering_of(m, densities);
    }
    real place = walk.from + width * source_place((step_depth.x + step_depth.y + step_depth.z) / 3.0);
    RayPoint at = sunlit_point(planet, ray, place);
    Stokes source = dimmed(shell_source(table, air, walk.shell, at, cos_azimuth_at(at, ray.nu), sine_over_sun(at)),
                           diffuse_share(ray, place));
    factors.diffuse = factors.diffuse + factors.transmittance * segment.mean * source.i * width;
    factors = with_polarised(factors, factors.transmittance * segment.mean * width, source);
    factors.transmittance = factors.transmittance * segment.through;
    factors.depth = factors.depth + step_depth;
    factors.peaks = factors.peaks + air.peaks * width;
  }
  return factors;
}

// ground_light() under air cut into shells.
vec3 shell_ground_light(PlanetData planet, MomentTableData table, Ray ray, vec3 transmittance) {
  RayPoint end = sunlit_point(planet, lit_ray(planet, ray), ray.length_);
  vec3 irradiance = shell_sun_irradiance(planet, end.mu_sun) * sun_share(ray, ray.length_, 0.0) +
                    moment_ground_irradiance(table, end.mu_sun);
  return transmittance * planet.ground_albedo * irradiance / kPi;
}

// sky_factors() for air cut into shells, the ground behind it.
SkyFactors shell_sky_factors(PlanetData planet, MomentTableData table, Ray ray, uint parts) {
  SkyFactors factors = shell_air_factors(planet, table, ray, parts);
  if (ray.at_ground && ray.length_ >= 0.0) {
    factors.diffuse = factors.diffuse + shell_ground_light(planet, table, ray, factors.transmittance);
  }
  return factors;
}
