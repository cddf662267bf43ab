// Multiple scattering as a few spherical-harmonic moments of the radiance at each (altitude, sun elevation). The field
// in a spherical shell under a collimated sun is mirror-symmetric about the plane of the local vertical and the sun,
// so cosine harmonics suffice: M_lm = integral of L Y_lm, m >= 0, in the frame (up, sun's azimuth), orthonormal.
// What molecules make of polarised light depends on three more numbers, P_m, in which Q and U count as I does in M_2m.
// The logarithm and the ratios that are stored (moment_places.glsl) interpolate well over the many decades of a twilight.
// The includer defines:
//   uint source_degree();  the highest l of what is scattered again, at most as high
//   uint scattered_degree();  the highest l that the media scatter, apart from what molecules do with polarised light
//   bool delta_scaled();   whether forward peaks are taken as unscattered light [W76]
//   uint shell_rows(), real shell_altitude(uint k);  rows at listed altitudes (shells.glsl); 0 rows: altitude = top y^2
//   vec3 fetch_moment(uint k, real x, real y);  what is stored at k

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
  real of[kMaxHarmonics];
};

Harmonics harmonics(real mu, real cos_azimuth) {
  Harmonics y;
  real s2 = max(1.0 - mu * mu, 0.0);
  real s = sqrt(s2);
  real c1 = cos_azimuth;
  real c2 = 2.0 * c1 * c1 - 1.0;
  real c3 = c1 * (2.0 * c2 - 1.0);
  real c4 = 2.0 * c2 * c2 - 1.0;
  real c5 = 2.0 * c1 * c4 - c3;
  real c6 = 2.0 * c3 * c3 - 1.0;
  real c7 = 2.0 * c1 * c6 - c5;
  real c8 = 2.0 * c4 * c4 - 1.0;
  real s3 = s2 * s;
  real s4 = s2 * s2;
  real s5 = s4 * s;
  real s6 = s4 * s2;
  real s7 = s6 * s;
  real s8 = s4 * s4;
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
  y.of[15] = mu * ((7.367870314565687 * mu2 - 8.186522571739651) * mu2 + 1.754254836801354);
  y.of[16] = s * c1 * ((9.511879675109636 * mu2 - 6.341253116739757) * mu2 + 0.45294665119569694);
  y.of[17] = mu * s2 * c2 * (7.190305177459986 * mu2 - 2.396768392486662);
  y.of[18] = s3 * c3 * (4.403144694917254 * mu2 - 0.4892382994352504);
  y.of[19] = 2.0756623148810416 * mu * s4 * c4;
  y.of[20] = 0.6563820568401701 * s5 * c5;
  y.of[21] = ((14.684485723822165 * mu2 - 20.024298714302954) * mu2 + 6.674766238100984) * mu2 - 0.3178460113381421;
  y.of[22] = mu * s * c1 * ((19.226504963118135 * mu2 - 17.478640875561943) * mu2 + 2.9131068125936572);
  y.of[23] = s2 * c2 * ((15.199886781996238 * mu2 - 8.29084733563431) * mu2 + 0.46060262975746175);
  y.of[24] = mu * s3 * c3 * (10.133257854664159 * mu2 - 2.7636157785447706);
  y.of[25] = s4 * c4 * (5.550213908015966 * mu2 - 0.5045649007287242);
  y.of[26] = 2.366619162231752 * mu * s5 * c5;
  y.of[27] = 0.6831841051919143 * s6 * c6;
  y.of[28] = mu * (((29.293954795250123 * mu2 - 47.32100390001943) * mu2 + 21.50954722728156) * mu2 - 2.3899496919201733);
  y.of[29] = s * c1 * (((38.75225965289993 * mu2 - 44.714145753346074) * mu2 + 12.194767023639837) * mu2 - 0.4516580379125866);
  y.of[30] = mu * s2 * c2 * ((31.64108750981626 * mu2 - 24.339298084474045) * mu2 + 3.31899519333737);
  y.of[31] = s3 * c3 * ((22.37362754230805 * mu2 - 10.326289634911408) * mu2 + 0.46937680158688216);
  y.of[32] = mu * s4 * c4 * (13.49180504672677 * mu2 - 3.113493472321562);
  y.of[33] = s5 * c5 * (6.745902523363384 * mu2 - 0.5189155787202603);
  y.of[34] = 2.6459606618019005 * mu * s6 * c6;
  y.of[35] = 0.7071627325245963 * s7 * c7;
  y.of[36] = (((58.47336811322075 * mu2 - 109.15028714467873) * mu2 + 62.97131950654543) * mu2 - 11.449330819371895) * mu2 + 0.31803696720477487;
  y.of[37] = mu * s * c1 * (((77.96449081762768 * mu2 - 109.15028714467874) * mu2 + 41.98087967103029) * mu2 - 3.8164436064572986);
  y.of[38] = s2 * c2 * (((65.22977295619205 * mu2 - 65.22977295619205) * mu2 + 15.053024528352012) * mu2 - 0.4561522584349095);
  y.of[39] = mu * s3 * c3 * ((48.175380056526215 * mu2 - 32.116920037684146) * mu2 + 3.705798465886632);
  y.of[40] = s4 * c4 * ((31.097074109356495 * mu2 - 12.438829643742599) * mu2 + 0.4784165247593307);
  y.of[41] = mu * s5 * c5 * (17.24955311049054 * mu2 - 3.449910622098108);
  y.of[42] = s6 * c6 * (7.9849914908931385 * mu2 - 0.5323327660595426);
  y.of[43] = 2.9157066406993195 * mu * s7 * c7;
  y.of[44] = 0.7289266601748299 * s8 * c8;
  return y;
}

// Y_2m is k.T.k of a symmetric, traceless T, k being the direction. E = theta.T.theta - phi.T.phi and F = 2 theta.T.phi,
// with unit vectors theta down and phi toward growing azimuth, are to Q and U what Y_2m is to I.
struct Quadrupole {
  real e[kPolarisedMoments];
  real f[kPolarisedMoments];
};

// `sine`: of the azimuth, or 1 for F over this sine.
Quadrupole quadrupole_of(real mu, real cos_azimuth, real sine) {
  real s = sqrt(max(1.0 - mu * mu, 0.0));
  real c = cos_azimuth;
  real n = sine;
  Quadrupole a;
  a.e[0] = 0.94617469575756 * s * s;
  a.e[1] = -1.0925484305920792 * s * mu * c;
  a.e[2] = 0.54627421529603959 * (1.0 + mu * mu) * (2.0 * c * c - 1.0);
  a.f[0] = 0.0;
  a.f[1] = 1.0925484305920792 * s * n;
  a.f[2] = -2.1850968611841584 * mu * n * c;
  return a;
}

// The azimuth from the sun's is at most half a turn: its sine is not negative.
real sine_of_azimuth(real cos_azimuth) { return sqrt(max(1.0 - cos_azimuth * cos_azimuth, 0.0)); }

Quadrupole quadrupole(real mu, real cos_azimuth) {
  return quadrupole_of(mu, cos_azimuth, sine_of_azimuth(cos_azimuth));
}

// The share f of a medium's scattering that counts as light that was not scattered, where the field's harmonics are kept
// up to degree N (`l`): from the Legendre moments chi_N (`kept`) and chi_(N+1) (`next`) of its phase function.
// Scattering multiplies the field's harmonics of degree l by chi_l. With a share f unscattered, and moments
// (chi_l - f) / (1 - f) for the rest, those up to N are multiplied by chi_l exactly whatever f is, and all above N by f.
// f = 0 loses what a forward peak keeps of them; f = chi_(N+1) [W76] keeps too much, as chi_l falls with l. f is the mean
// of chi_l over all l > N, for a field whose harmonics fall by r a degree and chi_l = chi_(N+1) q^(l-N-1) with
// q = chi_(N+1) / chi_N: f = chi_(N+1) (1 - r) / (1 - r q). A field falls the faster the higher N is: r = 60 /
// (60 + (N + 1)^2) suits Earth's skies, clear at N = 2 and hazy at N = 5 and 6, and dust at N = 8.
vec3 forward_peak(uint l, vec3 kept, vec3 next) {
  vec3 q = min(max(next, vec3(0.0)) / max(kept, vec3(1e-6)), vec3(1.0));
  real n = real(l + 1u);
  return max(next, vec3(0.0)) / (vec3(1.0) + (vec3(1.0) - q) * (60.0 / (n * n)));
}

// The air as diffuse light meets it: scattering by degree, sum over media of scattering times the phase function's
// Legendre moment (no further 4 pi: convolution on the sphere), and extinction. With delta_scaled() forward_peak() of
// each medium counts as light that was not scattered.
struct DiffuseAir {
  vec3 extinction;
  vec3 peaks;             // 1/km, what delta-scaling leaves out of it
  vec3 phase_scattering;  // 1/(km sr) toward the sun's angle, by the whole phase function
  vec3 dipoles;           // of polarised light: dipole_scattering() of the molecules, whose degree 2 is left out below
  vec3 degree[kMaxDegree + 1];
};

DiffuseAir with_diffuse_medium(DiffuseAir air, uint i, real d, vec3 phase) {
  if (i < medium_count()) {
    MediumData m = medium(i);
    vec3 scattering = m.scattering * d;
    bool molecular = polarised() && is_molecular(i);
    vec3 f = delta_scaled() && !molecular ? m.peak[moment_degree()] : vec3(0.0);
    air.extinction = air.extinction + m.absorption * d + scattering * (vec3(1.0) - f);
    air.peaks = air.peaks + scattering * f;
    air.phase_scattering = air.phase_scattering + scattering * phase;
    air.degree[0] = air.degree[0] + scattering * (vec3(1.0) - f);
    if (molecular) {
      air.dipoles = air.dipoles + scattering * dipole_share(i) * kDipole;
    } else {
      UNROLL for (uint l = 1u; l <= kMaxDegree; l++) {
        air.degree[l] = air.degree[l] + scattering * (m.legendre[l] - f);
      }
    }
  }
  return air;
}

DiffuseAir diffuse_air(Densities d, Phases p) {
  DiffuseAir air;
  air.extinction = vec3(0.0);
  air.peaks = vec3(0.0);
  air.phase_scattering = vec3(0.0);
  air.dipoles = vec3(0.0);
  UNROLL for (uint l = 0u; l <= kMaxDegree; l++) {
    air.degree[l] = vec3(0.0);
  }
  air = with_diffuse_medium(air, 0u, d.of[0], p.of[0]);
  air = with_diffuse_medium(air, 1u, d.of[1], p.of[1]);
  air = with_diffuse_medium(air, 2u, d.of[2], p.of[2]);
  air = with_diffuse_medium(air, 3u, d.of[3], p.of[3]);
  air = with_diffuse_medium(air, 4u, d.of[4], p.of[4]);
  air = with_diffuse_medium(air, 5u, d.of[5], p.of[5]);
  air = with_diffuse_medium(air, 6u, d.of[6], p.of[6]);
  air = with_diffuse_medium(air, 7u, d.of[7], p.of[7]);
  return air;
}

// The sum with what the moments of degree l scatter into the harmonics' direction, over the isotropic moment. Degrees
// here and media above are gone through by calls: one run of spirv-opt writes out no loop in a loop.
vec3 with_degree(vec3 sum, uint l, uint most, MomentCoordinate c, DiffuseAir air, Harmonics y) {
  if (l <= moment_degree() && l <= most) {
    uint k = moment_place(l, 0u);
    vec3 part = fetch_moment(k, c.x, c.y) * y.of[k];
    UNROLL for (uint m = 1u; m <= l; m++) {
      part = part + fetch_moment(k + m, c.x, c.y) * y.of[k + m];
    }
    sum = sum + air.degree[l] * part;
  }
  return sum;
}

// Of polarised light, which molecules alone scatter with more than its mean: a dipole's 3/(16 pi) times 16 pi/3 D/10.
const real kDipoleMoment = 1.0 / (10.0 * kDipole);

// What dipoles add to light scattered out of the field that the table holds at c, over its moment M_00.
Stokes dipole_source(MomentCoordinate c, vec3 dipoles, Harmonics y, Quadrupole a) {
  Stokes sum = no_light();
  UNROLL for (uint m = 0u; m < kPolarisedMoments; m++) {
    vec3 part = fetch_moment(polarised_place(m), c.x, c.y);
    sum.i = sum.i + part * y.of[moment_place(2u, m)];
    sum.q = sum.q - part * a.e[m];
    sum.u = sum.u - part * a.f[m];
  }
  vec3 strength = dipoles * kDipoleMoment;
  sum.i = sum.i * strength;
  sum.q = sum.q * strength;
  sum.u = sum.u * strength;
  return sum;
}

// The light that media of these degrees send into a direction, over the field's moment M_00; truncated
// at a low degree it may dip below zero opposite to a strong peak.
vec3 harmonic_sum(uint most, MomentCoordinate c, DiffuseAir air, Harmonics y) {
  vec3 sum = air.degree[0] * y.of[0];
  sum = with_degree(sum, 1u, most, c, air, y);
  sum = with_degree(sum, 2u, most, c, air, y);
  sum = with_degree(sum, 3u, most, c, air, y);
  sum = with_degree(sum, 4u, most, c, air, y);
  sum = with_degree(sum, 5u, most, c, air, y);
  sum = with_degree(sum, 6u, most, c, air, y);
  sum = with_degree(sum, 7u, most, c, air, y);
  return with_degree(sum, 8u, most, c, air, y);
}

// Light scattered into the direction (mu, azimuth) out of the field that the table holds at c, W/(m2 sr km); its
// moment M_00 is given. `sine`: of the azimuth; beyond half a turn from the sun's it is negative. u is proportional to it.
Stokes moment_source_of(vec3 isotropic, MomentCoordinate c, DiffuseAir air, real mu, real cos_azimuth, real sine) {
  Harmonics y = harmonics(mu, cos_azimuth);
  vec3 sum = harmonic_sum(scattered_degree(), c, air, y);
  Stokes source = no_light();
  if (polarised()) {
    Stokes dipoles = dipole_source(c, air.dipoles, y, quadrupole_of(mu, cos_azimuth, sine));
    sum = sum + dipoles.i;
    source.q = dipoles.q * isotropic;
    source.u = dipoles.u * isotropic;
  }
  source.i = max(sum, vec3(0.0)) * isotropic;
  return source;
}

Stokes moment_source(MomentTableData table, DiffuseAir air, RayPoint point, real cos_azimuth, real sine) {
  MomentCoordinate c = moment_coordinate(table, point.h, point.mu_sun);
  return moment_source_of(exp(fetch_moment(0u, c.x, c.y)), c, air, point.mu, cos_azimuth, sine);
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
