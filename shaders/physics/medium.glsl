// What the air is made of at an altitude: density of each medium, and its coefficients in 1/km.
// The includer defines the scene's media; on the device the first three are specialisation constants, so that a scene
// with two media runs a shader with two media:
//   uint medium_count();  uint density_profile(uint i);  uint phase_of(uint i);  MediumData medium(uint i);
//   vec2 density_layer(uint k);

// The later of two layers, `step` apart, that lies at or below h.
uint layer_below(MediumData m, real h, uint low, uint step) {
  uint next = low + step;
  if (next < m.layer_count) {
    if (density_layer(m.first_layer + next).x <= h) {
      return next;
    }
  }
  return low;
}

// Piecewise linear between [altitude, density] pairs, constant outside. A search by halves, written out: a loop over
// 256 layers in a march of 512 steps outruns the 65535 turns that the software device grants a shader, which then ends
// its loops without a word.
real layered_density(MediumData m, real h) {
  vec2 first = density_layer(m.first_layer);
  if (h <= first.x) {
    return first.y;
  }
  uint k = layer_below(m, h, 0u, 128u);  // half of kMaxDensityLayers
  k = layer_below(m, h, k, 64u);
  k = layer_below(m, h, k, 32u);
  k = layer_below(m, h, k, 16u);
  k = layer_below(m, h, k, 8u);
  k = layer_below(m, h, k, 4u);
  k = layer_below(m, h, k, 2u);
  k = layer_below(m, h, k, 1u);
  vec2 below = density_layer(m.first_layer + k);
  if (k + 1u >= m.layer_count) {
    return below.y;
  }
  vec2 above = density_layer(m.first_layer + k + 1u);
  return below.y + (above.y - below.y) * (h - below.x) / (above.x - below.x);
}

// Relative density at altitude h, 1 at the profile's reference.
real density(uint profile, MediumData m, real h) {
  if (profile == kDensityExponential) {
    return exp(-h / m.scale_height);
  }
  if (profile == kDensityTent) {
    return max(0.0, 1.0 - abs(h - m.center) / m.half_width);
  }
  if (profile == kDensityLorentzian) {
    real x = (m.center - h) / m.half_width;
    return exp(-h / m.scale_height) / (1.0 + x * x);
  }
  if (profile == kDensityConstant) {
    return h <= m.below ? 1.0 : 0.0;
  }
  return layered_density(m, h);
}

// The media are gone through by calls with a literal index, not by a loop: only then do the specialisation constants
// fold, and a march on the software device runs at twice the speed. A call beyond medium_count() costs nothing.

// Phase function of each medium for one angle: constant along a ray.
struct Phases {
  real of[kMaxMedia];
};

real medium_phase(uint i, real nu) { return i < medium_count() ? phase_value(phase_of(i), medium(i).g, nu) : 0.0; }

Phases phases(real nu) {
  Phases p;
  p.of[0] = medium_phase(0u, nu);
  p.of[1] = medium_phase(1u, nu);
  p.of[2] = medium_phase(2u, nu);
  p.of[3] = medium_phase(3u, nu);
  p.of[4] = medium_phase(4u, nu);
  p.of[5] = medium_phase(5u, nu);
  p.of[6] = medium_phase(6u, nu);
  p.of[7] = medium_phase(7u, nu);
  return p;
}

Phases equal_phases(real value) {
  Phases p;
  for (uint i = 0u; i < kMaxMedia; i++) {
    p.of[i] = value;
  }
  return p;
}

struct Air {
  vec3 extinction;        // 1/km
  vec3 scattering;        // 1/km, all media
  vec3 phase_scattering;  // 1/(km sr): sum of scattering times phase function
};

Air with_medium(Air air, uint i, real h, real phase) {
  if (i < medium_count()) {
    MediumData m = medium(i);
    real d = density(density_profile(i), m, h);
    vec3 scattering = m.scattering * d;
    air.scattering = air.scattering + scattering;
    air.phase_scattering = air.phase_scattering + scattering * phase;
    air.extinction = air.extinction + scattering + m.absorption * d;
  }
  return air;
}

Air air_at(real h, Phases p) {
  Air air;
  air.extinction = vec3(0.0);
  air.scattering = vec3(0.0);
  air.phase_scattering = vec3(0.0);
  air = with_medium(air, 0u, h, p.of[0]);
  air = with_medium(air, 1u, h, p.of[1]);
  air = with_medium(air, 2u, h, p.of[2]);
  air = with_medium(air, 3u, h, p.of[3]);
  air = with_medium(air, 4u, h, p.of[4]);
  air = with_medium(air, 5u, h, p.of[5]);
  air = with_medium(air, 6u, h, p.of[6]);
  air = with_medium(air, 7u, h, p.of[7]);
  return air;
}

vec3 medium_scattering(uint i, real h) {
  if (i < medium_count()) {
    return medium(i).scattering * density(density_profile(i), medium(i), h);
  }
  return vec3(0.0);
}

vec3 extinction_at(real h) { return air_at(h, equal_phases(0.0)).extinction; }
