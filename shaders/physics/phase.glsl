// Phase functions, 1/sr, each with integral 1 over the sphere. nu = cosine between the view direction (away from the
// camera) and the direction to the sun: +1 looks into the sun; g > 0 scatters forward.

// Codes: the places of C++'s PhaseFunction, then those that no preset names (core/air/phase_functions.cpp).
CODE uint kPhaseRayleigh = 0u;
CODE uint kPhaseHenyeyGreenstein = 1u;
CODE uint kPhaseCornetteShanks = 2u;
CODE uint kPhaseSchlick = 3u;
CODE uint kPhaseIsotropic = 4u;
CODE uint kPhaseTable = 5u;        // physics/phase_table.glsl
CODE uint kPhaseDepolarized = 6u;  // Rayleigh's with depolarisation, for molecules that are not round

const real kPi = 3.14159265358979323846;

real phase_isotropic() { return 1.0 / (4.0 * kPi); }

real phase_rayleigh(real nu) { return 3.0 / (16.0 * kPi) * (1.0 + nu * nu); }

// [C50] ch. 1 eq. 254, [Bu95] eq. 12: gamma = rho / (2 - rho) of the depolarisation rho of light scattered at a right
// angle. 0 is Rayleigh's.
vec3 phase_depolarized(vec3 gamma, real nu) {
  return (vec3(1.0 + nu * nu) + gamma * (3.0 - nu * nu)) / (vec3(1.0) + gamma * 2.0) * (3.0 / (16.0 * kPi));
}

// 1 + g*g - 2*g*nu as (1-|g|)^2 + 2|g| times the distance from the peak. It does not cancel in the peak of either sign,
// where the plain form loses all digits at |g| = 0.99.
real phase_peak(real g, real nu) {
  real strength = abs(g);
  real from_peak = g < 0.0 ? 1.0 + nu : 1.0 - nu;
  return (1.0 - strength) * (1.0 - strength) + 2.0 * strength * from_peak;
}

// [HG41]
real phase_henyey_greenstein(real g, real nu) {
  real peak = phase_peak(g, nu);
  return (1.0 - g * g) / (4.0 * kPi * peak * sqrt(peak));
}

// [C92] eq. 8
real phase_cornette_shanks(real g, real nu) {
  real peak = phase_peak(g, nu);
  return 3.0 * (1.0 - g * g) * (1.0 + nu * nu) / (8.0 * kPi * (2.0 + g * g) * peak * sqrt(peak));
}

// [S93]: k approximates Henyey-Greenstein's g without the power 3/2. The cubic leaves -1 to 1 where |g| > 0.938 (a pole
// in the forward peak, negative beside it). It is limited, so that the peak is that of Henyey-Greenstein at g = 0.99.
real schlick_k(real g) { return clamp(1.55 * g - 0.55 * g * g * g, -0.9999, 0.9999); }

real phase_schlick(real g, real nu) {
  real k = schlick_k(g);
  real denominator = 1.0 - k * nu;
  return (1.0 - k * k) / (4.0 * kPi * denominator * denominator);
}

// Of a function that all channels share; 0, which has no norm, for any other code.
real phase_value(uint kind, real g, real nu) {
  if (kind == kPhaseRayleigh) {
    return phase_rayleigh(nu);
  }
  if (kind == kPhaseHenyeyGreenstein) {
    return phase_henyey_greenstein(g, nu);
  }
  if (kind == kPhaseCornetteShanks) {
    return phase_cornette_shanks(g, nu);
  }
  if (kind == kPhaseSchlick) {
    return phase_schlick(g, nu);
  }
  if (kind == kPhaseIsotropic) {
    return phase_isotropic();
  }
  return 0.0;
}
