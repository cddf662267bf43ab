// A pixel's fetches from the picture's table of factors.
// The includer defines:
//   const uint kRestBlocks;  blocks after those of single scattering

layout(set = 0, binding = 3) uniform sampler2D factors_lut;

#include "shared/factor_place.glsl"

vec3 fetch_factor(uint block, FactorPlace at) {
  if (table_from_space() && at.section == kSectionNoAir) {
    return vec3(0.0);
  }
  float blocks = float(bitCount(kScatteringMedia) + kRestBlocks);
  float u = (float(block * kSkyColumns) + 0.5 + at.x * float(kSkyColumns - 1u)) / (blocks * float(kSkyColumns));
  return textureLod(factors_lut, vec2(u, at.v), 0.0).rgb;
}

// Fetches light that is in the shared block, or in a block apart with the shared block's carrier.
vec3 fetch_shared(uint block, FactorPlace at) {
  return fetch_factor(block, at) * shared_carrier(at.section, at.nu);
}

vec3 single_at(uint i, FactorPlace at) {
  if (!scatters(i)) {
    return vec3(0.0);
  }
  uint block = single_block(i);
  return folded(i) ? fetch_shared(block, at) : fetch_factor(block, at) * medium_phase(i, at.nu);
}

// What dipoles scatter once, over nu^2 + 1.
vec3 dipoles_at(FactorPlace at) {
  vec3 sum = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    sum += is_molecular(i) ? single_at(i, at) / medium_phase(i, at.nu) * dipole_share(i) * kDipole : vec3(0.0);
  }
  return sum;
}

// With Q, which a block holds for light that is not sunlight scattered once, and U, which the next one holds.
Stokes with_stokes(Stokes light, uint block, FactorPlace at, vec3 direction) {
  light.q = fetch_factor(block, at);
  light.u = fetch_factor(block + 1u, at);
  return with_sunlight(light, dipoles_at(at), direction, scene.sun.direction);
}
