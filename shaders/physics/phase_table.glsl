// A phase function by table: logarithms of its values, by channel, at kPhaseSamples scattering angles, angle = pi x^2
// with x evenly spaced: dense in the forward peak, 0.35 degrees apart at the other end. Between samples the logarithm
// is linear in x.
// Behind each table stands a smoothed copy for integrals over all directions by a few of them: its peak is spread so
// that they resolve it, its low moments are kept.
// The includer defines:
//   vec3 phase_sample(uint k);  of all tables, one behind the other

// Place in the table in samples, 0 to kPhaseSamples - 1.
real phase_table_place(real nu) {
  real angle = atan(sqrt(max((1.0 - nu) * (1.0 + nu), 0.0)), nu);
  return sqrt(angle / kPi) * real(kPhaseSamples - 1u);
}

vec3 phase_by_samples(uint first, real nu) {
  real place = phase_table_place(nu);
  uint k = min(uint(place), kPhaseSamples - 2u);
  real share = place - real(k);
  return exp(phase_sample(first + k) * (1.0 - share) + phase_sample(first + k + 1u) * share);
}

vec3 phase_by_table(uint table, real nu) { return phase_by_samples(2u * table * kPhaseSamples, nu); }
vec3 gathered_by_table(uint table, real nu) { return phase_by_samples((2u * table + 1u) * kPhaseSamples, nu); }
