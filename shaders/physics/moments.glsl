// Multiple scattering as a few spherical-harmonic moments of the radiance at each (altitude, sun elevation). The field
// in a spherical shell under a collimated sun is mirror-symmetric about the plane of the local vertical and the sun,
// so cosine harmonics suffice: M_lm = integral of L Y_lm, m >= 0, in the frame (up, sun's azimuth), orthonormal.
// Stored: log M_00 and the ratios M_lm / M_00, which interpolate well over the many decades of a twilight.
// The includer defines:
//   uint moment_degree();  the highest l kept, 0 to 4
//   bool delta_scaled();   whether forward peaks are taken as unscattered light [W76]
//   uint shell_rows(), real shell_altitude(uint k);  rows at listed altitudes (shells.glsl); 0 rows: altitude = top y^2
//   vec3 fetch_moment(uint k, real x, real y);  k = l(l+1)/2 + m; k = moment_count() is log of the ground's irradiance

uint moment_count() { return (moment_degree() + 1u) * (moment_degree() + 2u) / 2u; }

// Where (h, mu_sun) stands in the table, unit range: h = top y^2, sun elevation = scale sinh(v), v linear in x. With rows
// at listed altitudes y is shell_coordinate()'s.
struct MomentCoordinate {
  real x;  // sun
  real y;  // altitude
};

real arc_sinh(real x) {
  real a = abs(x);
  real y = log(a + sqrt(a * a + 1.0));
  return x < 0.0 ? -y : y;
}

MomentCoordinate moment_coordinate(MomentTableData table, real h, real mu_sun) {
  real elevation = atan(mu_sun, sqrt(max(1.0 - mu_sun * mu_sun, 0.0)));
  MomentCoordinate c;
  c.x = clamp((arc_sinh(elevation / table.elevation_scale) - table.v_low) / (table.v_high - table.v_low), 0.0, 1.0);
  c.y = sqrt(clamp(h / table.top, 0.0, 1.0));
  return c;
}

struct MomentState {
  real h;
  real mu_sun;
};

MomentState moment_state(MomentTableData table, real x, real y) {
  real v = table.v_low + (table.v_high - table.v_low) * x;
  real elevation = table.elevation_scale * 0.5 * (exp(v) - exp(-v));
  MomentState s;
  s.h = shell_rows() > 0u ? shell_altitude(uint(y * real(shell_rows() - 1u) + 0.5)) : table.top * y * y;
  s.mu_sun = sin(elevation);
  return s;
}

// Real orthonormal cosine harmonics of direction (mu, azimuth from the sun's).
struct Harmonics {
  real of[kMaxMoments];
};

Harmonics harmonics(real mu, real cos_azimuth) {
  Harmonics y;
  real s2 = max(1.0 - mu * mu, 0.0);
  real s = sqrt(s2);
  real c1 = cos_azimuth;
  real c2 = 2.0 * c1 * c1 - 1.0;
  real c3 = c1 * (2.0 * c2 - 1.0);
  real c4 = 2.0 * c2 * c2 - 1.0;
  real mu2 = mu * mu;
  y.of[0] = 0.28209479177387814;
  y.of[1] = 0.48860251190291992 * mu;
  y.of[2] = 0.48860251190291992 * s * c1;
  y.of[3] = 0.31539156525252005 * (3.0 * mu2 - 1.0);
  y.of[4] = 1.0925484305920792 * mu * s * c1;
  y.of[5] = 0.54627421529603959 * s2 * c2;
  y.of[6] = 0.37317633259011546 * mu * (5.0 * mu2 - 3.0);
  y.of[7] = 0.45704579946446577 * s * (5.0 * mu2 - 1.0) * c1;
  y.of[8] = 1.4453057213202769 * mu * s2 * c2;
  y.of[9] = 0.59004358992664352 * s2 * s * c3;
  y.of[10] = 0.10578554691520431 * (mu2 * (35.0 * mu2 - 30.0) + 3.0);
  y.of[11] = 0.66904654355728921 * mu * s * (7.0 * mu2 - 3.0) * c1;
  y.of[12] = 0.47308734787878004 * s2 * (7.0 * mu2 - 1.0) * c2;
  y.of[13] = 1.7701307697799307 * mu * s2 * s * c3;
  y.of[14] = 0.62583573544917614 * s2 * s2 * c4;
  return y;
}

// The air as diffuse light meets it: scattering by degree, sum over media of scattering times the phase function's
// Legendre moment (no further 4 pi: convolution on the sphere), and extinction. Delta-scaled, the part f = moment of
// degree N+1 of each phase function counts as light that was not scattered.
struct DiffuseAir {
  vec3 extinction;
  vec3 phase_scattering;  // 1/(km sr) toward the sun's angle, by the whole phase function
  vec3 degree0;
  vec3 degree1;
  vec3 degree2;
  vec3 degree3;
  vec3 degree4;
};

real legendre_moment(MediumData m, uint l) {
  if (l == 0u) {
    return 1.0;
  }
  if (l == 1u) {
    return m.legendre1;
  }
  if (l == 2u) {
    return m.legendre2;
  }
  if (l == 3u) {
    return m.legendre3;
  }
  return l == 4u ? m.legendre4 : m.legendre5;
}

DiffuseAir with_diffuse_medium(DiffuseAir air, uint i, real h, real phase) {
  if (i < medium_count()) {
    MediumData m = medium(i);
    real d = density(density_profile(i), m, h);
    vec3 scattering = m.scattering * d;
    real f = delta_scaled() ? max(legendre_moment(m, moment_degree() + 1u), 0.0) : 0.0;
    air.extinction = air.extinction + m.absorption * d + scattering * (1.0 - f);
    air.phase_scattering = air.phase_scattering + scattering * phase;
    air.degree0 = air.degree0 + scattering * (1.0 - f);
    air.degree1 = air.degree1 + scattering * (m.legendre1 - f);
    air.degree2 = air.degree2 + scattering * (m.legendre2 - f);
    air.degree3 = air.degree3 + scattering * (m.legendre3 - f);
    air.degree4 = air.degree4 + scattering * (m.legendre4 - f);
  }
  return air;
}

DiffuseAir diffuse_air_at(real h, Phases p) {
  DiffuseAir air;
  air.extinction = vec3(0.0);
  air.phase_scattering = vec3(0.0);
  air.degree0 = vec3(0.0);
  air.degree1 = vec3(0.0);
  air.degree2 = vec3(0.0);
  air.degree3 = vec3(0.0);
  air.degree4 = vec3(0.0);
  air = with_diffuse_medium(air, 0u, h, p.of[0]);
  air = with_diffuse_medium(air, 1u, h, p.of[1]);
  air = with_diffuse_medium(air, 2u, h, p.of[2]);
  air = with_diffuse_medium(air, 3u, h, p.of[3]);
  air = with_diffuse_medium(air, 4u, h, p.of[4]);
  air = with_diffuse_medium(air, 5u, h, p.of[5]);
  air = with_diffuse_medium(air, 6u, h, p.of[6]);
  air = with_diffuse_medium(air, 7u, h, p.of[7]);
  return air;
}

// Light scattered into the direction (mu, azimuth) out of the field that the table holds at c, W/(m2 sr km); its
// moment M_00 is given.
vec3 moment_source_of(vec3 isotropic, MomentCoordinate c, DiffuseAir air, real mu, real cos_azimuth) {
  Harmonics y = harmonics(mu, cos_azimuth);
  vec3 sum = air.degree0 * y.of[0];
  if (moment_degree() >= 1u) {
    sum = sum + air.degree1 * (fetch_moment(1u, c.x, c.y) * y.of[1] + fetch_moment(2u, c.x, c.y) * y.of[2]);
  }
  if (moment_degree() >= 2u) {
    sum = sum + air.degree2 * (fetch_moment(3u, c.x, c.y) * y.of[3] + fetch_moment(4u, c.x, c.y) * y.of[4] +
                               fetch_moment(5u, c.x, c.y) * y.of[5]);
  }
  if (moment_degree() >= 3u) {
    sum = sum + air.degree3 * (fetch_moment(6u, c.x, c.y) * y.of[6] + fetch_moment(7u, c.x, c.y) * y.of[7] +
                               fetch_moment(8u, c.x, c.y) * y.of[8] + fetch_moment(9u, c.x, c.y) * y.of[9]);
  }
  if (moment_degree() >= 4u) {
    sum = sum + air.degree4 * (fetch_moment(10u, c.x, c.y) * y.of[10] + fetch_moment(11u, c.x, c.y) * y.of[11] +
                               fetch_moment(12u, c.x, c.y) * y.of[12] + fetch_moment(13u, c.x, c.y) * y.of[13] +
                               fetch_moment(14u, c.x, c.y) * y.of[14]);
  }
  // Truncated at a low degree the field may dip below zero opposite to a strong peak.
  return max(sum, vec3(0.0)) * isotropic;
}

vec3 moment_source(MomentTableData table, DiffuseAir air, real h, real mu_sun, real mu, real cos_azimuth) {
  MomentCoordinate c = moment_coordinate(table, h, mu_sun);
  return moment_source_of(exp(fetch_moment(0u, c.x, c.y)), c, air, mu, cos_azimuth);
}

// Irradiance on the ground by the light that the table holds.
vec3 moment_ground_irradiance(MomentTableData table, real mu_sun) {
  MomentCoordinate c = moment_coordinate(table, 0.0, mu_sun);
  return exp(fetch_moment(moment_count(), c.x, 0.0));
}

// Azimuth of the view from the sun's in the local frame of a point on the ray, as its cosine.
real cos_azimuth_at(RayPoint point, real nu) {
  real s = sqrt(max((1.0 - point.mu * point.mu) * (1.0 - point.mu_sun * point.mu_sun), 0.0));
  return s > 1e-6 ? clamp((nu - point.mu * point.mu_sun) / s, -1.0, 1.0) : 1.0;
}
