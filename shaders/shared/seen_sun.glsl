// Where air bends light: the sun that a point of the air sees, from the table of seen directions (transmittance.comp),
// and the lower half of a table of sunlight, which is that table.
layout(set = 0, binding = 2) uniform sampler2D seen_lut;

// Bilinear in 32 bits: a sampler's weights may have 8, and differences are taken.
vec4 seen_light(real h, real mu) {
  TransmittanceCoordinate c = transmittance_coordinate(scene.planet, h, mu);
  ivec2 last = textureSize(seen_lut, 0) - 1;
  vec2 at = vec2(c.x, c.y) * vec2(last);
  ivec2 low = min(ivec2(at), last - 1);
  vec2 part = at - vec2(low);
  vec4 below = mix(texelFetch(seen_lut, low, 0), texelFetch(seen_lut, low + ivec2(1, 0), 0), part.x);
  vec4 above = mix(texelFetch(seen_lut, low + ivec2(0, 1), 0), texelFetch(seen_lut, low + ivec2(1, 1), 0), part.x);
  return mix(below, above, part.y);
}

// The cosine of a zenith angle that is less by a small one.
real raised(real mu, real angle) {
  real s = sqrt(max(1.0 - mu * mu, 0.0));
  return min(mu * (1.0 - 0.5 * angle * angle) + s * angle * (1.0 - angle * angle / 6.0), 1.0);
}

// The sun whose true zenith cosine is `mu`: a seen angle z with z + bending(z) = true angle. Newton's steps begin at the
// horizon or below the root, from where they do not pass it.
SeenSun seen_sun(real h, real mu) {
  const uint kNewton = 8u;
  const real kApart = 5e-4;
  real horizon = horizon_mu(scene.planet, h);
  real s = sqrt(max(1.0 - mu * mu, 0.0));
  real under = s * horizon - mu * sqrt(max(1.0 - horizon * horizon, 0.0));
  real angle = max(under * (1.0 + under * under / 6.0), 0.0);
  for (uint i = 0u; i < kNewton; i++) {
    real here = seen_light(h, raised(mu, angle)).a;
    real next = seen_light(h, raised(mu, angle + kApart)).a;
    angle += max(here - angle, 0.0) / (1.0 + (here - next) / kApart);
  }
  SeenSun sun;
  sun.mu = max(raised(mu, angle), horizon);
  real here = seen_light(h, sun.mu).a;
  real one = seen_light(h, raised(sun.mu, kApart)).a;
  real two = seen_light(h, raised(sun.mu, 2.0 * kApart)).a;
  sun.spread = beam_spread(scene.planet, h, sun.mu, here, (3.0 * here - 4.0 * one + two) / (2.0 * kApart));
  return sun;
}
