// Sunlight that arrives at a point of the air, and the sun's disc.
// The includer defines, from its table or by a march (transmittance.glsl):
//   vec3 transmittance_to_top(PlanetData planet, real h, real mu);  from h along mu, as if there were no ground; where
//     the air bends light, toward a sun at lifted_sun(), with the beam's spreading
//   real bending_along(PlanetData planet, real h, real mu);  bending_to_top(); 0 where the air bends no light

// Transmittance toward the sun: zero in the planet's shadow. It does not fade around the local horizon: air high up is
// lit while the ground is dark, and that light is the twilight. The test is meets_ground() without its quotient, hence
// the tangent is lit only to rounding; transmittance_coordinate() takes the same root.
vec3 transmittance_to_sun(PlanetData planet, real h, real mu_sun) {
  real mu = lifted_sun(h, mu_sun);
  real lit = (planet.ground_radius + h) * mu < -horizon_distance(planet, h) ? 0.0 : 1.0;
  return transmittance_to_top(planet, h, mu) * lit;
}

bool sun_is_up(PlanetData planet, real h, real mu_sun) { return !meets_ground(planet, h, lifted_sun(h, mu_sun)); }

// Zenith cosine of the sun that is seen from altitude h.
real seen_sun_mu(PlanetData planet, real h, real mu_sun) {
  real seen = mu_sun;
  if (bends_light()) {
    real horizon = h > 0.0 ? horizon_mu(planet, h) : 0.0;
    real s = sqrt(max(1.0 - mu_sun * mu_sun, 0.0));
    // A step leaves a sixth of the error, at the horizon, where it is greatest.
    for (uint i = 0u; i < 4u; i++) {
      real bent = bending_along(planet, h, max(seen, horizon));
      seen = mu_sun * (1.0 - 0.5 * bent * bent) + s * bent;
    }
  }
  return seen;
}

// The direction of the sun that is seen with zenith cosine `seen` where the vertical is `up`; `sun`: the true one.
vec3 raised_to(vec3 up, vec3 sun, real seen) {
  if (!bends_light()) {
    return sun;
  }
  vec3 level = sun - up * dot(sun, up);
  return up * seen + level * (sqrt(max(1.0 - seen * seen, 0.0)) / max(length(level), 1e-6));
}

// A place's altitude where the tables hold it.
real altitude_in_air(PlanetData planet, Place place) {
  return clamp(optical_altitude_at(place.h), 0.0, planet.atmosphere_height);
}

// The sun as a place among things has it.
struct PlaceSun {
  real h;     // altitude_in_air() of the place
  real mu;    // true zenith cosine, by which tables are asked
  vec3 seen;  // where it is seen: what is lit and what lies in shadow
};

PlaceSun sun_at(PlanetData planet, Place place, vec3 sun) {
  PlaceSun at;
  at.h = altitude_in_air(planet, place);
  at.mu = dot(sun, true_vertical(planet, place.up));
  at.seen = raised_to(place.up, sun, seen_sun_mu(planet, at.h, at.mu));
  return at;
}

// Cosine between the vertical and the sun that the ground sees, 0 for a sun that is not up.
real ground_facing(PlanetData planet, real mu_sun) { return max(seen_sun_mu(planet, 0.0, mu_sun), 0.0); }

// Bending that a ray has before it from altitude h, to the top of the air; of a ray that falls to the ground less that
// which it would have if it went the other way.
real bending_ahead(PlanetData planet, bool falls, real h, real mu) {
  return falls ? -bending_along(planet, h, -mu) : bending_along(planet, h, mu);
}

// The ray, ready for sunlit_point().
Ray lit_ray(PlanetData planet, Ray ray) {
  ray.bent = bends_light() && ray.length_ > 0.0 ? bending_ahead(planet, ray.falls, ray.h, ray.mu) : 0.0;
  return ray;
}

// The point with the sun as it stands there.
RayPoint sunlit_point(PlanetData planet, Ray ray, real t) {
  RayPoint point = point_on_ray(planet, ray, t);
  if (bends_light()) {
    real bent = ray.bent - bending_ahead(planet, ray.falls, point.h, point.mu);
    point = with_turned_sun(point, ray, bent);
  }
  return point;
}

// The published lesson's fade of direct light, 1 where it is off (kSunFade on the device).
real sun_fade(SunData sun, real mu_sun) {
  return sun_fade_enabled() ? clamp(sun.fade_scale * mu_sun + sun.fade_bias, 0.0, 1.0) : 1.0;
}

// Radiance of the disc over that at its centre; zero outside. I(mu) = 1 - u (1 - mu). `chord`: length of the difference
// between the direction and the sun's, 2 sin(angle/2); a cosine this near 1 has no digits left.
real disc_profile(SunData sun, real chord) {
  real x = chord / (2.0 * sin(0.5 * sun.angular_radius));
  real mu = sqrt(max(1.0 - x * x, 0.0));
  return x < 1.0 ? 1.0 - sun.limb_darkening * (1.0 - mu) : 0.0;
}
