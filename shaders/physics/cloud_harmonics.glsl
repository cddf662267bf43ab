// Moments of the light in a cell from eight ordinates of one zenith cosine, at azimuths of 45 a degrees or turned by
// 22.5 from there, and the light that moments send into them: Fourier sums with the symmetry of the azimuths, then
// harmonics up to degree 2.
//
// The middle one of a hemisphere's three rings is turned against the two others. Eight even azimuths send 2.6 % more
// light than there is through a wall toward 22.5 degrees, or 5.2 % less through one toward 0; the rings, of which the
// middle one sends nearly half, offset this.

const real kCosine = 0.92387953251128674;  // of 22.5 degrees
const real kSine = 0.38268343236508977;
const real kRoot = 0.70710678118654752;

// Harmonics of degree 0 to 2 by i = l (l + 1) + m.
struct CloudMoments {
  real of[9];
};

struct CloudRing {
  real of[8];
};

// Sums of a ring's radiance times cosines and sines of azimuth.
struct CloudWaves {
  real all;
  real cos1;
  real sin1;
  real cos2;
  real sin2;
};

// From azimuths that count from the ring's first to those that count from the east (side 1), or back (side -1).
CloudWaves turned_waves(CloudWaves w, bool turned, real side) {
  real c1 = turned ? kCosine : 1.0;
  real s1 = turned ? side * kSine : 0.0;
  real c2 = turned ? kRoot : 1.0;
  real s2 = turned ? side * kRoot : 0.0;
  CloudWaves out_;
  out_.all = w.all;
  out_.cos1 = c1 * w.cos1 - s1 * w.sin1;
  out_.sin1 = s1 * w.cos1 + c1 * w.sin1;
  out_.cos2 = c2 * w.cos2 - s2 * w.sin2;
  out_.sin2 = s2 * w.cos2 + c2 * w.sin2;
  return out_;
}

// Adds `weight` times the sum over the ring of its radiance times the harmonics.
CloudMoments with_ring(CloudMoments sums, CloudRing v, bool turned, real z, real weight) {
  real s2 = 1.0 - z * z;
  real s = sqrt(s2);
  real b = v.of[1] - v.of[5];
  real d = v.of[3] - v.of[7];
  real even0 = v.of[0] + v.of[4];
  real even1 = v.of[1] + v.of[5];
  real even2 = v.of[2] + v.of[6];
  real even3 = v.of[3] + v.of[7];
  CloudWaves w;
  w.all = weight * (even0 + even1 + even2 + even3);
  w.cos1 = weight * (v.of[0] - v.of[4] + kRoot * (b - d));
  w.sin1 = weight * (v.of[2] - v.of[6] + kRoot * (b + d));
  w.cos2 = weight * (even0 - even2);
  w.sin2 = weight * (even1 - even3);
  w = turned_waves(w, turned, 1.0);
  sums.of[0] = sums.of[0] + 0.28209479177387814 * w.all;
  sums.of[1] = sums.of[1] + 0.48860251190291992 * s * w.sin1;
  sums.of[2] = sums.of[2] + 0.48860251190291992 * z * w.all;
  sums.of[3] = sums.of[3] + 0.48860251190291992 * s * w.cos1;
  sums.of[4] = sums.of[4] + 0.54627421529603959 * s2 * w.sin2;
  sums.of[5] = sums.of[5] + 1.0925484305920792 * s * z * w.sin1;
  sums.of[6] = sums.of[6] + 0.31539156525252005 * (3.0 * z * z - 1.0) * w.all;
  sums.of[7] = sums.of[7] + 1.0925484305920792 * s * z * w.cos1;
  sums.of[8] = sums.of[8] + 0.54627421529603959 * s2 * w.cos2;
  return sums;
}

// The sum over the harmonics in each direction of the ring.
CloudRing ring_of(CloudMoments m, bool turned, real z) {
  real s2 = 1.0 - z * z;
  real s = sqrt(s2);
  CloudWaves w;
  w.all = 0.28209479177387814 * m.of[0] + 0.48860251190291992 * z * m.of[2] +
          0.31539156525252005 * (3.0 * z * z - 1.0) * m.of[6];
  w.cos1 = s * (0.48860251190291992 * m.of[3] + 1.0925484305920792 * z * m.of[7]);
  w.sin1 = s * (0.48860251190291992 * m.of[1] + 1.0925484305920792 * z * m.of[5]);
  w.cos2 = 0.54627421529603959 * s2 * m.of[8];
  w.sin2 = 0.54627421529603959 * s2 * m.of[4];
  w = turned_waves(w, turned, -1.0);
  real b = kRoot * (w.cos1 + w.sin1);
  real d = kRoot * (w.sin1 - w.cos1);
  CloudRing ring;
  ring.of[0] = w.all + w.cos2 + w.cos1;
  ring.of[1] = w.all + w.sin2 + b;
  ring.of[2] = w.all - w.cos2 + w.sin1;
  ring.of[3] = w.all - w.sin2 + d;
  ring.of[4] = w.all + w.cos2 - w.cos1;
  ring.of[5] = w.all + w.sin2 - b;
  ring.of[6] = w.all - w.cos2 - w.sin1;
  ring.of[7] = w.all - w.sin2 - d;
  return ring;
}

// Whether a ring of ordinates is turned: the flattest and the steepest are.
bool ring_is_turned(real z) { return abs(abs(z) - 0.5) > 0.2; }
