// The table of factors of a camera above the air; sky_table.glsl has that of a camera inside. Rows are those of a
// camera at the top of the air, where rays enter: ground and limb. Columns go by the sun's zenith cosine at a ray's
// foot, its point on the ground or else its lowest point. The terminator therefore lies along a column, however far the
// camera.

const uint kSectionNoAir = 3u;  // the ray misses the air

// Three fifths of the columns stand within this of the terminator, in the sun's zenith cosine.
const real kTerminatorWidth = 0.2;

real terminator_coordinate(real mu_sun) { return mu_sun / (abs(mu_sun) + kTerminatorWidth); }

real terminator_mu(real coordinate) { return kTerminatorWidth * coordinate / (1.0 - abs(coordinate)); }

// The foot of the rays of one row, from a camera at altitude h, and the sun there over all azimuths.
struct RayFoot {
  real inside;  // distance from the point of entry
  real middle;  // of the sun's zenith cosines at the foot
  real half_;   // half their range
};

// mu, across: cosine and sine of the zenith angle at the camera; way: distance to the point of entry; mu_top: cosine
// there.
RayFoot ray_foot(PlanetData planet, real h, real mu_sun, real mu, real across, real way, real mu_top, bool at_ground) {
  real top = planet.atmosphere_height;
  real r_top = planet.ground_radius + top;
  RayFoot foot;
  foot.inside = at_ground ? distance_to_ground(planet, top, mu_top) : -r_top * mu_top;
  real radius = at_ground ? planet.ground_radius : r_top * sqrt(max(1.0 - mu_top * mu_top, 0.0));
  real distance_ = way + foot.inside;
  foot.middle = mu_sun * (planet.ground_radius + h + distance_ * mu) / radius;
  foot.half_ = sqrt(max(1.0 - mu_sun * mu_sun, 0.0)) * distance_ * across / radius;
  return foot;
}

// Where the sun's zenith cosine at the foot hardly varies with azimuth, columns go by the azimuth alone.
const real kSameSun = 1e-4;

real foot_column(RayFoot foot, real cos_azimuth) {
  real low = terminator_coordinate(foot.middle - foot.half_);
  real high = terminator_coordinate(foot.middle + foot.half_);
  real at = terminator_coordinate(foot.middle + foot.half_ * cos_azimuth);
  bool same = foot.half_ < kSameSun;
  return same ? 0.5 + 0.5 * cos_azimuth : clamp((at - low) / (same ? 1.0 : high - low), 0.0, 1.0);
}

// Cosine of the azimuth from the sun's.
real column_azimuth(RayFoot foot, real x) {
  if (foot.half_ < kSameSun) {
    return 2.0 * x - 1.0;
  }
  real low = terminator_coordinate(foot.middle - foot.half_);
  real high = terminator_coordinate(foot.middle + foot.half_);
  return clamp((terminator_mu(low + (high - low) * x) - foot.middle) / foot.half_, -1.0, 1.0);
}

// The place in the table of a view from altitude h above the air, given its zenith cosine mu and sine.
SkyTableCoordinate space_table_coordinate(PlanetData planet, real h, real mu_sun, real mu, real across,
                                          real cos_azimuth) {
  AirEntry entry = air_entry(planet, h, mu);
  real mu_top = clamp(-entry.root / (planet.ground_radius + planet.atmosphere_height), -1.0, -1e-9);
  SkyTableCoordinate c = sky_table_coordinate(planet, planet.atmosphere_height, mu_top, 1.0);
  c.x = foot_column(
      ray_foot(planet, h, mu_sun, mu, across, entry.distance_, mu_top, c.section == kSectionGround), cos_azimuth);
  c.section = entry.misses ? kSectionNoAir : c.section;
  return c;
}

// The part of a texel's ray inside the air. x, y: unit range; section: ground or limb. steepest: bound on its zenith
// cosine.
TableRay space_table_ray(PlanetData planet, real h, real mu_sun, real x, uint section, real y, real steepest) {
  real top = planet.atmosphere_height;
  real r = planet.ground_radius + h;
  real r_top = planet.ground_radius + top;
  SkyTableState state = sky_table_state(planet, top, 0.0, section, y);
  TableRay found;
  Ray ray;
  ray.h = top;
  ray.mu = clamp(state.mu, -steepest, 0.0);
  ray.at_ground = section == kSectionGround;
  ray.falls = ray.at_ground;
  ray.length_ = ray.at_ground ? state.length_ : distance_to_top(planet, top, ray.mu);
  real across = min(r_top * sqrt(max(1.0 - ray.mu * ray.mu, 0.0)) / r, 1.0);
  real mu = -sqrt(1.0 - across * across);
  real way = (h - top) * (r + r_top) / max(-r_top * ray.mu - r * mu, 1e-9);
  RayFoot foot = ray_foot(planet, h, mu_sun, mu, across, way, ray.mu, ray.at_ground);
  found.cos_azimuth = column_azimuth(foot, x);
  ray.nu = clamp(mu * mu_sun + across * sqrt(max(1.0 - mu_sun * mu_sun, 0.0)) * found.cos_azimuth, -1.0, 1.0);
  ray.mu_sun = clamp((r * mu_sun + way * ray.nu) / r_top, -1.0, 1.0);
  found.ray = ray;
  return found;
}
