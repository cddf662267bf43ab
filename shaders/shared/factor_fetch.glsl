// A pixel's fetches from the picture's table of factors.
// The includer defines:
//   const uint kRestBlocks;  blocks after those of single scattering

layout(set = 0, binding = 3) uniform sampler2D factors_lut;

// Where a direction falls in each block.
struct FactorPlace {
  float x;
  float v;
  float nu;
  uint section;
};

FactorPlace factor_place(vec3 d) {
  vec3 s = scene.sun.direction;
  // The tiny term keeps the zenith, of the view or of the sun, away from a division by 0.
  float across = sqrt((d.x * d.x + d.z * d.z) * (s.x * s.x + s.z * s.z));
  float cos_azimuth = (d.x * s.x + d.z * s.z) / max(across, 1e-20);
  SkyTableCoordinate c = sky_table_coordinate(scene.planet, scene.camera.altitude, d.y, cos_azimuth);
  float rows = float(kGroundRows + kLimbRows + kSkyRows);
  FactorPlace at;
  at.x = c.x;
  at.v = (float(section_first(c.section)) + 0.5 + c.y * float(section_rows(c.section) - 1u)) / rows;
  at.nu = dot(d, s);
  at.section = c.section;
  return at;
}

vec3 fetch_factor(uint block, FactorPlace at) {
  float blocks = float(bitCount(kScatteringMedia) + kRestBlocks);
  float u = (float(block * kSkyColumns) + 0.5 + at.x * float(kSkyColumns - 1u)) / (blocks * float(kSkyColumns));
  return textureLod(factors_lut, vec2(u, at.v), 0.0).rgb;
}

// Of light that is, or would be, in the shared block.
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
