// A closed-form sky, `exponential`: no march, no table. Single scattering of each medium is its column along the ray
// times the mean of an exponential whose exponent (view depth plus sun depth) is linear along that column; light
// scattered more than once is the same with an isotropic source whose logarithm is linear.
// A medium that stands low has its depth in the first part of a higher one's column. The line with the right mean is
// too dark at the near end, from which the light of a deep ray comes. The line along the first part is too dark
// elsewhere. The result is the brighter of the two, with a smooth passage between them.
// The includer defines:
//   AnalyticMedium analytic_medium(uint i);  AnalyticDiffuse analytic_diffuse();  bool scatters(uint i);
//   real share_above(uint i, uint j);  real share_below(uint i, uint j);

vec3 extinction_of(uint i) { return medium(i).scattering + medium(i).absorption; }

// How medium j's column divides along medium i's: the shares of j's column above i's lower end and above i's upper end.
// The straight line between the two shares has the right mean.
struct Shares {
  real lower;
  real upper;
};

Shares shares_of(real mean_above) {
  Shares s;
  s.lower = min(2.0 * mean_above, 1.0);
  s.upper = max(2.0 * mean_above - 1.0, 0.0);
  return s;
}

// Returns a, or b where b is far greater; smooth between.
vec3 smooth_max(vec3 a, vec3 b) {
  vec3 more = max(b - a, vec3(0.0));
  return a + more * more / max(more + a * 0.2, vec3(1e-30));
}

// Moves the logarithm of scattered light to another sun position, as far as a slope taken at the camera can be trusted.
vec3 moved(vec3 light, real mu_sun, real camera_mu_sun) {
  return light + max(min(analytic_diffuse().slope * (mu_sun - camera_mu_sun), vec3(2.0)), vec3(-20.0));
}

// Distance at which a ray that starts in the planet's shadow, a half cylinder behind the planet, leaves it.
real shadow_exit(PlanetData planet, Ray ray) {
  real r = planet.ground_radius + ray.h;
  real a = max(1.0 - ray.nu * ray.nu, 1e-12);
  real b = r * (ray.mu - ray.mu_sun * ray.nu);
  real c = ray.h * (2.0 * planet.ground_radius + ray.h) - r * r * ray.mu_sun * ray.mu_sun;
  real side = (sqrt(max(b * b - a * c, 0.0)) - b) / a;
  real day = ray.nu > 0.0 ? -r * ray.mu_sun / ray.nu : side;
  return max(min(side, day), 0.0);
}

// A part of a ray on which the altitude only rises or only falls, and the light of it.
struct Leg {
  real start;   // distance from the ray's start
  real end;
  vec3 before;  // optical depth ahead of it
};
struct LegLight {
  vec3 radiance;  // for a sun of irradiance 1
  vec3 depth;     // optical depth along it
};

// Distance from altitude h to the middle of a medium's column along an outward ray.
real mean_distance(AnalyticMedium a, real h, real column) {
  return (a.scale_height + max(a.base - h, 0.0)) * column / max(column_above(a, h), 1e-30);
}

// The leg up to the top, from the ray's start or lowest point. Single scattering begins where the planet's shadow ends.
LegLight rising_leg(PlanetData planet, Ray ray, Leg leg, real camera_mu_sun, Phases p) {
  RayPoint start = point_on_ray(planet, ray, leg.start);
  bool night = meets_ground(planet, start.h, start.mu_sun);
  real dawn = night ? clamp(shadow_exit(planet, ray), leg.start, leg.end) : leg.start;
  RayPoint near = point_on_ray(planet, ray, dawn);
  real columns[kMaxMedia];      // from the start
  real lit_columns[kMaxMedia];  // from `near`
  real sun_columns[kMaxMedia];  // from `near` to the sun
  LegLight light;
  light.radiance = vec3(0.0);
  light.depth = vec3(0.0);
  vec3 dark_depth = leg.before;
  real weight = 0.0;
  real distance_sum = 0.0;
  for (uint j = 0u; j < medium_count(); j++) {
    AnalyticMedium a = analytic_medium(j);
    columns[j] = column_outward(planet, a, start.h, start.mu);
    lit_columns[j] = night ? min(column_outward(planet, a, near.h, near.mu), columns[j]) : columns[j];
    sun_columns[j] = column_to_space(planet, a, near.h, near.mu_sun);
    light.depth = light.depth + extinction_of(j) * columns[j];
    dark_depth = dark_depth + extinction_of(j) * (columns[j] - lit_columns[j]);
    real scattered = dot(medium(j).scattering, vec3(1.0)) * lit_columns[j];
    weight = weight + scattered;
    distance_sum = distance_sum + scattered * mean_distance(a, near.h, lit_columns[j]);
  }
  // The point that the leg's light comes from on average.
  RayPoint far = point_on_ray(planet, ray, min(dawn + distance_sum / max(weight, 1e-30), leg.end));
  real sun_far[kMaxMedia];
  for (uint j = 0u; j < medium_count(); j++) {
    AnalyticMedium b = analytic_medium(j);
    real mass_far = column_to_space(planet, b, far.h, far.mu_sun) / max(column_above(b, far.h), 1e-30);
    sun_far[j] = column_above(b, near.h) * min(mass_far, 1e3);
  }
  vec3 near_source = leg.before - moved(analytic_diffuse().near, start.mu_sun, camera_mu_sun);
  vec3 far_source = leg.before - moved(analytic_diffuse().far, far.mu_sun, camera_mu_sun);
  for (uint i = 0u; i < medium_count(); i++) {
    if (scatters(i)) {
      vec3 single_near = dark_depth;
      vec3 single_far = dark_depth;
      vec3 diffuse_near = near_source;
      vec3 diffuse_far = far_source;
      vec3 sun_depth = dark_depth;   // at the near end
      vec3 single_rise = vec3(0.0);  // over the whole column, as steep as at the near end
      vec3 diffuse_rise = far_source - near_source;
      for (uint j = 0u; j < medium_count(); j++) {
        Shares s = shares_of(share_above(i, j));
        vec3 extinction = extinction_of(j);
        single_near = single_near + extinction * (lit_columns[j] * (1.0 - s.lower) + sun_columns[j] * s.lower);
        single_far = single_far + extinction * (lit_columns[j] * (1.0 - s.upper) + sun_far[j] * s.upper);
        diffuse_near = diffuse_near + extinction * (columns[j] * (1.0 - s.lower));
        diffuse_far = diffuse_far + extinction * (columns[j] * (1.0 - s.upper));
        real steep = 1.0 / max(s.lower, 1e-6);
        sun_depth = sun_depth + extinction * sun_columns[j];
        single_rise = single_rise + extinction * (max(lit_columns[j] - sun_columns[j], 0.0) * steep);
        diffuse_rise = diffuse_rise + extinction * (columns[j] * steep);
      }
      vec3 single = smooth_max(mean_exponential3(single_near, single_far),
                               mean_exponential3(sun_depth, sun_depth + single_rise));
      vec3 diffuse = smooth_max(mean_exponential3(diffuse_near, diffuse_far),
                                mean_exponential3(near_source, near_source + diffuse_rise));
      single = single * (p.of[i] * lit_columns[i]);
      light.radiance = light.radiance + medium(i).scattering * (single + diffuse * columns[i]);
    }
  }
  return light;
}

// The leg down to the ground, or to the lowest point of a ray that misses it: a ray's first leg, with no depth before
// it.
LegLight falling_leg(PlanetData planet, Ray ray, Leg leg, real camera_mu_sun, Phases p) {
  RayPoint near = point_on_ray(planet, ray, leg.start);
  RayPoint far = point_on_ray(planet, ray, leg.end);
  real lit = 0.5 * ((meets_ground(planet, near.h, near.mu_sun) ? 0.0 : 1.0) +
                    (meets_ground(planet, far.h, far.mu_sun) ? 0.0 : 1.0));
  real columns[kMaxMedia];
  real sun_near[kMaxMedia];
  real sun_far[kMaxMedia];
  LegLight light;
  light.radiance = vec3(0.0);
  light.depth = vec3(0.0);
  for (uint j = 0u; j < medium_count(); j++) {
    AnalyticMedium a = analytic_medium(j);
    real from_far = column_outward(planet, a, far.h, abs(far.mu));
    columns[j] = max(from_far - column_outward(planet, a, near.h, abs(near.mu)), 0.0);
    sun_near[j] = column_to_space(planet, a, near.h, near.mu_sun);
    sun_far[j] = column_to_space(planet, a, far.h, far.mu_sun);
    light.depth = light.depth + extinction_of(j) * columns[j];
  }
  vec3 diffuse_near = moved(analytic_diffuse().near, near.mu_sun, camera_mu_sun);
  vec3 diffuse_far = moved(analytic_diffuse().ground, far.mu_sun, camera_mu_sun);
  for (uint i = 0u; i < medium_count(); i++) {
    if (scatters(i)) {
      vec3 view_near = vec3(0.0);
      vec3 view_far = vec3(0.0);
      vec3 to_sun_near = vec3(0.0);
      vec3 to_sun_far = vec3(0.0);
      for (uint j = 0u; j < medium_count(); j++) {
        Shares s = shares_of(share_below(i, j));
        vec3 extinction = extinction_of(j);
        view_near = view_near + extinction * (columns[j] * s.upper);
        view_far = view_far + extinction * (columns[j] * s.lower);
        to_sun_near = to_sun_near + extinction * (sun_near[j] + (sun_far[j] - sun_near[j]) * s.upper);
        to_sun_far = to_sun_far + extinction * (sun_near[j] + (sun_far[j] - sun_near[j]) * s.lower);
      }
      vec3 single = mean_exponential3(view_near + to_sun_near, view_far + to_sun_far) * (p.of[i] * lit);
      vec3 diffuse = mean_exponential3(view_near - diffuse_near, view_far - diffuse_far);
      light.radiance = light.radiance + medium(i).scattering * columns[i] * (single + diffuse);
    }
  }
  return light;
}

// Light that the ground sends up for a sun of irradiance 1.
vec3 analytic_ground(PlanetData planet, real mu_sun, real camera_mu_sun) {
  vec3 sun_depth = vec3(0.0);
  for (uint j = 0u; j < medium_count(); j++) {
    sun_depth = sun_depth + extinction_of(j) * column_to_space(planet, analytic_medium(j), 0.0, mu_sun);
  }
  vec3 sky = exp(moved(analytic_diffuse().irradiance, mu_sun, camera_mu_sun));
  return planet.ground_albedo * (exp(-sun_depth) * max(mu_sun, 0.0) + sky) / kPi;
}

PathRadiance analytic_exponential(PlanetData planet, SunData sun, Ray ray, real camera_mu_sun) {
  PathRadiance path;
  path.radiance = vec3(0.0);
  path.transmittance = vec3(1.0);
  if (ray.length_ < 0.0) {
    return path;
  }
  Phases p = phases(ray.nu);
  LegLight down;
  down.radiance = vec3(0.0);
  down.depth = vec3(0.0);
  LegLight up = down;
  Leg leg;
  leg.start = 0.0;
  leg.end = clamp(-(planet.ground_radius + ray.h) * ray.mu, 0.0, ray.length_);
  leg.before = vec3(0.0);
  if (ray.mu < 0.0) {
    down = falling_leg(planet, ray, leg, camera_mu_sun, p);
  }
  leg.start = leg.end;
  leg.end = ray.length_;
  leg.before = down.depth;
  if (!ray.at_ground) {
    up = rising_leg(planet, ray, leg, camera_mu_sun, p);
  }
  path.transmittance = exp(-(down.depth + up.depth));
  path.radiance = down.radiance + up.radiance;
  if (ray.at_ground) {
    RayPoint end = point_on_ray(planet, ray, ray.length_);
    path.radiance = path.radiance + path.transmittance * analytic_ground(planet, end.mu_sun, camera_mu_sun);
  }
  path.radiance = path.radiance * sun.irradiance;
  return path;
}
