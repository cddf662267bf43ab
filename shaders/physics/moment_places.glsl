// Places of a table's moments, block by block: M_lm and, where light is polarised, P_m (moments.glsl). The table stores
// log M_00, the ratios of the others to M_00 and, in the last block, the logarithm of the ground's irradiance.
// The includer defines:
//   uint moment_degree();  the highest l kept, 0 to 8
//   bool polarised();

uint moment_place(uint l, uint m) { return l * (l + 1u) / 2u + m; }

uint harmonic_count() { return moment_place(moment_degree() + 1u, 0u); }

// m: 0 to 2
uint polarised_place(uint m) { return harmonic_count() + m; }

uint moment_count() { return harmonic_count() + (polarised() ? kPolarisedMoments : 0u); }

bool is_logarithm(uint k) { return k == 0u || k == moment_count(); }

// Light that is nowhere negative has |M_lm| <= sqrt(2l + 1) M_00 (the squares of all Y_lm of a degree add up to
// (2l + 1) / 4 pi) and |P_m| < 4.5 M_00 (most for m = 0: level light that is polarised wholly). Both are below 8. A
// correction of a field that all but vanishes, as far above the air, may break that.
vec3 moment_code(uint k, vec3 value, vec3 isotropic) {
  return is_logarithm(k) ? log(max(value, vec3(1e-30))) : max(min(value / isotropic, vec3(8.0)), vec3(-8.0));
}

vec3 moment_of_code(uint k, vec3 code, vec3 isotropic) { return is_logarithm(k) ? exp(code) : code * isotropic; }
