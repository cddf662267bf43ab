// Sunlight that arrives at a point of the air, and the sun's disc.
// The includer defines, from its table or by a march (transmittance.glsl):
//   vec3 transmittance_to_top(PlanetData planet, real h, real mu);  from h along mu, as if there were no ground

// Transmittance toward the sun: zero in the planet's shadow. It does not fade around the local horizon: air high up is
// lit while the ground is dark, and that light is the twilight. The test is meets_ground() without its quotient, hence
// the tangent is lit only to rounding; transmittance_coordinate() takes the same root.
vec3 transmittance_to_sun(PlanetData planet, real h, real mu_sun) {
  real lit = (planet.ground_radius + h) * mu_sun < -horizon_distance(planet, h) ? 0.0 : 1.0;
  return transmittance_to_top(planet, h, mu_sun) * lit;
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
