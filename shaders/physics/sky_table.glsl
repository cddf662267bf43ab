// A picture's light tabulated over view directions, for a camera inside the atmosphere. Three sections stacked in y,
// each with the true horizon exactly at its edge, so that no cell straddles it: ground, limb (from the true horizon up
// to level, where a ray dips before it rises) and sky. x is the azimuth from the sun's over pi.

const uint kSectionGround = 0u;
const uint kSectionLimb = 1u;
const uint kSectionSky = 2u;

struct SkyTableRows {
  uint ground;
  uint limb;
  uint sky;
};

struct SkyTableCoordinate {
  real x;
  uint section;
  real y;  // unit range within the section
};

struct SkyTableState {
  real mu;
  real cos_azimuth;
  real length_;  // for a ray to the ground
};

// The ray that a texel stands for.
struct TableRay {
  Ray ray;
  real cos_azimuth;  // from the sun's, at the camera
};

// Ground: y from the root of the distance's logarithm. It resolves light gathered over metres and over kilometres. It
// also resolves angles around straight down; the logarithm alone grows with the square of such an angle.
real ground_row(real h, real horizon, real path) {
  real scale = max(h, 1e-5);
  return sqrt(clamp(log(1.0 + (path - h) / scale) / max(log(1.0 + (horizon - h) / scale), 1e-6), 0.0, 1.0));
}

real ground_path(real h, real horizon, real y) {
  real scale = max(h, 1e-5);
  return h + scale * (exp(y * y * log(1.0 + (horizon - h) / scale)) - 1.0);
}

SkyTableCoordinate sky_table_coordinate(PlanetData planet, real h, real mu, real cos_azimuth) {
  SkyTableCoordinate c;
  c.x = sqrt(clamp(0.5 - 0.5 * cos_azimuth, 0.0, 1.0));
  real horizon = horizon_mu(planet, h);
  if (mu >= 0.0) {
    c.section = kSectionSky;
    c.y = sqrt(clamp(mu / (1.0 + sqrt(max(1.0 - mu, 0.0))), 0.0, 1.0));  // y^2 = 1 - sqrt(1 - mu)
  } else {
    bool ground = mu < horizon;
    real limb = sqrt(clamp(1.0 - mu / min(horizon, -1e-9), 0.0, 1.0));
    real path = distance_to_ground(planet, h, min(mu, horizon));
    c.section = ground ? kSectionGround : kSectionLimb;
    c.y = ground ? ground_row(h, horizon_distance(planet, h), path) : limb;
  }
  return c;
}

SkyTableState sky_table_state(PlanetData planet, real h, real x, uint section, real y) {
  SkyTableState s;
  s.cos_azimuth = 1.0 - 2.0 * x * x;
  s.length_ = -1.0;
  if (section == kSectionSky) {
    s.mu = y * y * (2.0 - y * y);
  } else if (section == kSectionLimb) {
    s.mu = horizon_mu(planet, h) * (1.0 - y * y);
  } else {
    s.length_ = ground_path(h, horizon_distance(planet, h), y);
    real d = max(s.length_, 1e-9);
    real above = max(-(h * (2.0 * planet.ground_radius + h) + d * d) / (2.0 * (planet.ground_radius + h) * d), -1.0);
    real touching = -y;
    s.mu = h > 0.0 ? above : touching;  // no branch, as in table_texel_is_read()
  }
  return s;
}

// Angle of a row from straight up.
real table_row_angle(PlanetData planet, real h, uint section, real y) {
  real mu = sky_table_state(planet, h, 0.0, section, y).mu;
  return atan(sqrt(max(1.0 - mu * mu, 0.0)), mu);
}

real table_column_angle(real x) { return 2.0 * atan(x, sqrt(max(1.0 - x * x, 0.0))); }

// Angle between two directions by their zenith angles and the azimuth between them.
real angle_between(real a, real b, real azimuth) {
  real cosine = clamp(cos(a) * cos(b) + sin(a) * sin(b) * cos(azimuth), -1.0, 1.0);
  return atan(sqrt(1.0 - cosine * cosine), cosine);
}

// Directions of a picture, within an angle of an axis.
struct ViewCone {
  vec3 axis;
  real half_angle;  // pi and more: all directions
};

// Whether a table of texels `dx` and `dy` apart is read at (x, y) for a direction of the cone. It may say so of texels
// some hundredths of a radian beyond. Both sides of the sun's heading share a texel.
bool table_texel_is_read(PlanetData planet, real h, SkyTableCoordinate at, real dx, real dy, vec3 sun, ViewCone cone) {
  real level = sun.x * sun.x + sun.z * sun.z;
  // Up to a millimetre over the ground, ways to it are too short for rows apart: all may look up one.
  bool touching = at.section == kSectionGround && h < 1e-6;
  // No branch hangs on uniforms alone: Mesa's software device works the whole shader over again at each dispatch, for
  // their values, and keeps 1 MB of it each time.
  real all = max(cone.half_angle >= kPi ? 10.0 : 0.0, max(level <= 0.0 ? 10.0 : 0.0, touching ? 10.0 : 0.0));
  real across = cone.axis.x * sun.z - cone.axis.z * sun.x;
  real along = cone.axis.x * sun.x + cone.axis.z * sun.z;
  real axis_azimuth = atan(abs(across), along);
  real axis_angle = atan(sqrt(cone.axis.x * cone.axis.x + cone.axis.z * cone.axis.z), cone.axis.y);
  real low = table_row_angle(planet, h, at.section, max(at.y - dy, 0.0));
  real high = table_row_angle(planet, h, at.section, min(at.y + dy, 1.0));
  real angle = table_row_angle(planet, h, at.section, at.y);
  real azimuth = table_column_angle(at.x);
  real near = table_column_angle(max(at.x - dx, 0.0));
  real far = table_column_angle(min(at.x + dx, 1.0));
  // A direction in a cell is no farther from its corner than a row and a column are apart.
  real widest = max(max(sin(low), sin(high)), sin(angle));
  real cell = max(abs(low - angle), abs(high - angle)) + max(azimuth - near, far - azimuth) * widest;
  return !(angle_between(angle, axis_angle, azimuth - axis_azimuth) > cone.half_angle + cell + 0.02 + all);
}
