// The view ray that a texel of the picture's table of factors stands for.

Ray section_ray(SkyTableState state, uint section) {
  float h = scene.camera.altitude;
  float mu_sun = scene.sun.direction.y;
  state.mu = clamp(state.mu, -most_steep(), most_steep());
  float s = sqrt(max((1.0 - state.mu * state.mu) * (1.0 - mu_sun * mu_sun), 0.0));
  // The camera is inside the air: ray_in_atmosphere() would ask, by a branch that hangs on uniforms alone (see
  // table_texel_is_read()).
  Ray ray;
  ray.h = h;
  ray.mu = state.mu;
  ray.mu_sun = mu_sun;
  ray.nu = state.mu * mu_sun + s * state.cos_azimuth;
  ray.bent = 0.0;
  ray.at_ground = section == kSectionGround;
  ray.falls = ray.at_ground;
  ray.length_ = ray.at_ground ? state.length_ : distance_to_top(scene.planet, h, state.mu);
  return ray;
}

uint section_of_row(uint row) {
  return row < kGroundRows ? kSectionGround : row < kGroundRows + kLimbRows ? kSectionLimb : kSectionSky;
}

TableRay table_ray(uvec2 texel) {
  uint section = section_of_row(texel.y);
  float x = float(texel.x) / float(kSkyColumns - 1u);
  float y = float(texel.y - section_first(section)) / float(section_rows(section) - 1u);
  if (table_from_space()) {
    return space_table_ray(scene.planet, scene.camera.altitude, scene.sun.direction.y, x, section, y, most_steep());
  }
  SkyTableState state = sky_table_state(scene.planet, scene.camera.altitude, x, section, y);
  TableRay found;
  found.ray = section_ray(state, section);
  found.cos_azimuth = state.cos_azimuth;
  return found;
}

// A ray above the air has its own table, which is made as a whole.
bool texel_is_read(uvec2 texel, float half_angle) {
  SkyTableCoordinate at;
  at.section = section_of_row(texel.y);
  float rows = float(section_rows(at.section) - 1u);
  at.x = float(texel.x) / float(kSkyColumns - 1u);
  at.y = float(texel.y - section_first(at.section)) / rows;
  ViewCone cone;
  cone.axis = scene.camera.forward;
  cone.half_angle = half_angle;
  return table_from_space() || table_texel_is_read(scene.planet, scene.camera.altitude, at, 1.0 / float(kSkyColumns - 1u),
                                                   1.0 / rows, scene.sun.direction, cone);
}
