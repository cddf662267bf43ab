// A pixel's fetches from the picture's table of factors.
// The includer defines:
//   const uint kRestBlocks;  blocks after those of single scattering

layout(set = 0, binding = 3) uniform sampler2D factors_lut;

// Where a direction falls in each block.
struct FactorPlace {
  float x;
  float v;
  float nu;
};

FactorPlace factor_place(vec3 d) {
  vec3 s = scene.sun.direction;
  // Azimuth from the sun's, 0 to pi; the tiny term keeps atan away from (0, 0) at the zenith.
  float azimuth = atan(abs(d.x * s.z - d.z * s.x) + 1e-20, d.x * s.x + d.z * s.z);
  SkyTableCoordinate c = sky_table_coordinate(scene.planet, scene.camera.altitude, d.y, azimuth);
  float rows = float(kGroundRows + kLimbRows + kSkyRows);
  FactorPlace at;
  at.x = c.x;
  at.v = (float(section_first(c.section)) + 0.5 + c.y * float(section_rows(c.section) - 1u)) / rows;
  at.nu = dot(d, s);
  return at;
}

vec3 fetch_factor(uint block, FactorPlace at) {
  float blocks = float(bitCount(kScatteringMedia) + kRestBlocks);
  float u = (float(block * kSkyColumns) + 0.5 + at.x * float(kSkyColumns - 1u)) / (blocks * float(kSkyColumns));
  return textureLod(factors_lut, vec2(u, at.v), 0.0).rgb;
}

vec3 single_at(uint i, FactorPlace at) {
  if (scatters(i)) {
    return fetch_factor(single_block(i), at) * medium_phase(i, at.nu);
  }
  return vec3(0.0);
}
