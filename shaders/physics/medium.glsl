// What the air is made of at an altitude: density of each medium, and its coefficients in 1/km.
// The includer defines the scene's media; on the device the first three are specialisation constants, so that a scene
// with two media runs a shader with two media:
//   uint medium_count();  uint density_profile(uint i);  uint phase_of(uint i);  bool phase_is_sharp(uint i);
//   MediumData medium(uint i);
//   vec2 density_layer(uint k);  vec3 phase_sample(uint k);
//   uint most_layers();  layers of the medium with the most, 0 where none has any

// Codes: the places of C++'s DensityProfile.
CODE uint kDensityExponential = 0u;
CODE uint kDensityTent = 1u;
CODE uint kDensityLorentzian = 2u;
CODE uint kDensityConstant = 3u;
CODE uint kDensityLayers = 4u;
CODE uint kDensityHeightFog = 5u;

CODE uint kSmoothProfiles = (1u << kDensityExponential) | (1u << kDensityLorentzian);  // a bit for each

// The later of two layers, `step` apart, that lies at or below h.
uint layer_below(MediumData m, real h, uint low, uint step) {
  uint next = low + step;
  bool is_there = step < most_layers() && next < m.layer_count;
  bool is_below = density_layer(m.first_layer + (is_there ? next : low)).x <= h;  // no branch: as of air_entry()
  return is_there && is_below ? next : low;
}

// Piecewise linear between [altitude, density] pairs, constant outside. The search by halves is written out: a loop
// over 256 layers in a march of 512 steps exceeds the 65535 turns that the software device grants a shader, which then
// ends its loops silently. Steps as long as the longest list fold away.
real layered_density(MediumData m, real h) {
  vec2 first = density_layer(m.first_layer);
  uint k = layer_below(m, h, 0u, 128u);  // half of kMaxDensityLayers
  k = layer_below(m, h, k, 64u);
  k = layer_below(m, h, k, 32u);
  k = layer_below(m, h, k, 16u);
  k = layer_below(m, h, k, 8u);
  k = layer_below(m, h, k, 4u);
  k = layer_below(m, h, k, 2u);
  k = layer_below(m, h, k, 1u);
  vec2 below = density_layer(m.first_layer + k);
  bool is_last = k + 1u >= m.layer_count;
  vec2 above = density_layer(m.first_layer + (is_last ? k : k + 1u));
  real between = below.y + (above.y - below.y) * (h - below.x) / (is_last ? 1.0 : above.x - below.x);
  return h <= first.x ? first.y : is_last ? below.y : between;
}

// Relative density at altitude h, 1 at the profile's reference.
real profile_density(uint profile, MediumData m, real h) {
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
  if (profile == kDensityHeightFog) {
    return exp(-max(h - m.below, 0.0) / m.scale_height);
  }
  if (profile == kDensityLayers) {
    return layered_density(m, h);
  }
  return 0.0;
}

// The same over optical lengths (refraction.glsl).
real density(uint profile, MediumData m, real g) {
  TrueAltitude a = true_altitude(g);
  return profile_density(profile, m, a.h) * a.stretch;
}

// Mean of exp(-x) over x from a to b: (exp(-a) - exp(-b))/(b - a). Where that loses digits it is the mean of the ends
// times tanh(d/2)/(d/2), d = b - a.
real mean_exponential(real a, real b) {
  real first = exp(-a);
  real last = exp(-b);
  real d = b - a;
  real near = 0.5 * (first + last) * (1.0 - d * d * (1.0 / 12.0 - d * d / 120.0));
  return abs(d) < 0.3 ? near : (first - last) / d;
}

// Mean density over a step of a ray around altitude h, along which altitude rises by `rise` (falls where it is
// negative). A height fog may be thinner than a step is high, so its mean is in closed form, level steps included. Any
// other medium's density is taken in the middle.
real step_density(uint profile, MediumData m, real h, real rise) {
  if (profile != kDensityHeightFog) {
    return density(profile, m, h);
  }
  TrueAltitude middle = true_altitude(h);
  real height = abs(rise) * middle.stretch;
  real low = middle.h - 0.5 * height - m.below;
  real even = clamp(-low / max(height, 1e-12), 0.0, 1.0);  // the share of the step at or below the base
  real above = mean_exponential(max(low, 0.0) / m.scale_height, max(low + height, 0.0) / m.scale_height);
  return (even + (1.0 - even) * above) * middle.stretch;
}

// A step of a ray that may be as high as a shell.
struct Stretch {
  real h;      // of the step's middle
  real rise;   // from the near end to the far end, below 0 where the ray goes down
  real bulge;  // height of both ends above the tangent in the middle, times 4
};

// The stretch of a step of this width around its middle.
Stretch stretch_of(PlanetData planet, RayPoint middle, real width) {
  Stretch s;
  s.h = middle.h;
  s.rise = width * middle.mu;
  s.bulge = 0.5 * width * width * (1.0 - middle.mu * middle.mu) / (planet.ground_radius + middle.h);
  return s;
}

// Mean density over a stretch. A smooth profile takes Gauss's rule of three nodes: in a shell of four scale heights the
// density in the middle is half of the mean. Other profiles are straight lines within a shell, or have a closed form.
real stretch_density(uint profile, MediumData m, Stretch s) {
  if ((kSmoothProfiles >> profile & 1u) == 0u) {
    return step_density(profile, m, s.h, s.rise);
  }
  real offset = 0.3872983346207417 * s.rise;
  real over = s.h + 0.15 * s.bulge;
  real sides = density(profile, m, max(over - offset, 0.0)) + density(profile, m, over + offset);
  return (5.0 * sides + 8.0 * density(profile, m, s.h)) * (1.0 / 18.0);
}

// Loops over the media have a constant number of turns and are marked UNROLL, so that they are written out when a
// pipeline's constants are known. Only then does a march on the software device run at twice the speed. A turn beyond
// medium_count() costs nothing.

// Phase function of each medium for one angle: constant along a ray.
struct Phases {
  vec3 of[kMaxMedia];
};

vec3 medium_phase(uint i, real nu) {
  if (i >= medium_count()) {
    return vec3(0.0);
  }
  if (phase_of(i) == kPhaseTable) {
    return phase_by_table(medium(i).phase_table, nu);
  }
  if (phase_of(i) == kPhaseDepolarized) {
    return phase_depolarized(medium(i).depolarization, nu);
  }
  return vec3(phase_value(phase_of(i), medium(i).g, nu));
}

Phases phases(real nu) {
  Phases p;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    p.of[i] = medium_phase(i, nu);
  }
  return p;
}

// The phase function for integrals over all directions by a few of them.
vec3 gathered_phase(uint i, real nu) {
  if (i < medium_count() && (phase_of(i) == kPhaseTable || phase_is_sharp(i))) {
    return gathered_by_table(medium(i).phase_table, nu);
  }
  return medium_phase(i, nu);
}

Phases gathered_phases(real nu) {
  Phases p;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    p.of[i] = gathered_phase(i, nu);
  }
  return p;
}

Phases equal_phases(real value) {
  Phases p;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    p.of[i] = vec3(value);
  }
  return p;
}

struct Air {
  vec3 extinction;        // 1/km
  vec3 scattering;        // 1/km, all media
  vec3 phase_scattering;  // 1/(km sr): sum of scattering times phase function
};

Air with_medium(Air air, uint i, real h, real rise, vec3 phase) {
  if (i < medium_count()) {
    MediumData m = medium(i);
    real d = step_density(density_profile(i), m, h, rise);
    // The product in brackets is constant along a ray.
    air.scattering = air.scattering + m.scattering * d;
    air.phase_scattering = air.phase_scattering + (m.scattering * phase) * d;
    air.extinction = air.extinction + (m.scattering + m.absorption) * d;
  }
  return air;
}

// The mean over a step, as step_density() has it.
Air air_over(real h, real rise, Phases p) {
  Air air;
  air.extinction = vec3(0.0);
  air.scattering = vec3(0.0);
  air.phase_scattering = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    air = with_medium(air, i, h, rise, p.of[i]);
  }
  return air;
}

Air air_at(real h, Phases p) { return air_over(h, 0.0, p); }

vec3 medium_scattering(uint i, real h, real rise) {
  if (i < medium_count()) {
    return medium(i).scattering * step_density(density_profile(i), medium(i), h, rise);
  }
  return vec3(0.0);
}

// Relative density of each medium.
struct Densities {
  real of[kMaxMedia];
};

Densities densities_at(real h) {
  Densities d;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    d.of[i] = i < medium_count() ? density(density_profile(i), medium(i), h) : 0.0;
  }
  return d;
}

Densities stretch_densities(Stretch s) {
  Densities d;
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    d.of[i] = i < medium_count() ? stretch_density(density_profile(i), medium(i), s) : 0.0;
  }
  return d;
}

vec3 scattering_of(uint i, Densities d) {
  if (i < medium_count()) {
    return medium(i).scattering * d.of[i];
  }
  return vec3(0.0);
}

vec3 extinction_at(real h) { return air_at(h, equal_phases(0.0)).extinction; }

vec3 extinction_over(real h, real rise) { return air_over(h, rise, equal_phases(0.0)).extinction; }
