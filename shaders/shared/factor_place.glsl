// Place of a direction in the picture's table of factors.

// The place is the same in each block.
struct FactorPlace {
  float x;
  float v;
  float nu;
  uint section;
};

FactorPlace factor_place(vec3 d) {
  vec3 s = scene.sun.direction;
  // The tiny term prevents a division by 0 where the view or the sun is at the zenith.
  float across = sqrt((d.x * d.x + d.z * d.z) * (s.x * s.x + s.z * s.z));
  float cos_azimuth = (d.x * s.x + d.z * s.z) / max(across, 1e-20);
  SkyTableCoordinate c;
  if (table_from_space()) {
    c = space_table_coordinate(scene.planet, scene.camera.altitude, s.y, d.y, sqrt(d.x * d.x + d.z * d.z), cos_azimuth);
  } else {
    c = sky_table_coordinate(scene.planet, scene.camera.altitude, d.y, cos_azimuth);
  }
  float rows = float(kGroundRows + kLimbRows + kSkyRows);
  FactorPlace at;
  at.x = c.x;
  at.v = (float(section_first(c.section)) + 0.5 + c.y * float(section_rows(c.section) - 1u)) / rows;
  at.nu = bends_light() ? dot(d, scene.sun.seen) : dot(d, s);
  at.section = c.section;
  return at;
}
