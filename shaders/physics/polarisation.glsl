// Polarised light. Molecules scatter as small dipoles: sunlight that they turn by a right angle is polarised across the
// plane of scattering, and polarised light is scattered unevenly again [C50] ch. 1 sec. 17. All other media are taken to
// scatter light evenly as to polarisation.
// Stokes parameters are those of the light seen in a direction, in W/(m2 sr), with reference to the plane of that
// direction and the vertical: q > 0 is polarised in this plane; u > 0 leans from downward toward growing azimuth.
// The includer defines:
//   bool polarised();  whether molecules polarise; else q and u are 0

struct Stokes {
  vec3 i;
  vec3 q;
  vec3 u;
};

Stokes no_light() {
  Stokes none;
  none.i = vec3(0.0);
  none.q = vec3(0.0);
  none.u = vec3(0.0);
  return none;
}

bool is_molecular(uint i) {
  return i < medium_count() && (phase_of(i) == kPhaseRayleigh || phase_of(i) == kPhaseDepolarized);
}

// The share of a molecular medium's scattering that dipoles do, the rest being even and unpolarised: 1 - D in [Bu95]'s
// mixture, D = (1 - gamma)/(1 + 2 gamma).
vec3 dipole_share(uint i) {
  vec3 gamma = medium(i).depolarization;
  return (vec3(1.0) - gamma) / (vec3(1.0) + gamma * 2.0);
}

// What dipoles scatter at an angle of cosine nu, for unpolarised light: the parts in and across the plane of scattering,
// over 3/(16 pi) of their coefficient, are nu^2 and 1.
const real kDipole = 3.0 / (16.0 * 3.14159265358979323846);

// 1/(km sr): coefficient of dipoles times kDipole at these densities.
vec3 dipole_scattering(Densities d) {
  vec3 sum = vec3(0.0);
  if (polarised()) {
    UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
      if (is_molecular(i)) {
        sum = sum + medium(i).scattering * dipole_share(i) * (d.of[i] * kDipole);
      }
    }
  }
  return sum;
}
