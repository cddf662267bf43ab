// Moments of the light in a cell from eight ordinates of one zenith cosine, at azimuths of 22.5 + 45 a degrees, and the
// light that moments send into them: Fourier sums with the symmetry of the azimuths, then harmonics up to degree 2.

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

// Adds `weight` times the sum over the ring of its radiance times the harmonics.
CloudMoments with_ring(CloudMoments sums, CloudRing v, real z, real weight) {
  real s2 = 1.0 - z * z;
  real s = sqrt(s2);
  real a = v.of[0] - v.of[4];
  real b = v.of[1] - v.of[5];
  real c = v.of[2] - v.of[6];
  real d = v.of[3] - v.of[7];
  real even0 = v.of[0] + v.of[4];
  real even1 = v.of[1] + v.of[5];
  real even2 = v.of[2] + v.of[6];
  real even3 = v.of[3] + v.of[7];
  real all = weight * (even0 + even1 + even2 + even3);
  real cos1 = weight * (kCosine * (a - d) + kSine * (b - c));
  real sin1 = weight * (kSine * (a + d) + kCosine * (b + c));
  real cos2 = weight * kRoot * (even0 - even1 - even2 + even3);
  real sin2 = weight * kRoot * (even0 + even1 - even2 - even3);
  sums.of[0] = sums.of[0] + 0.28209479177387814 * all;
  sums.of[1] = sums.of[1] + 0.48860251190291992 * s * sin1;
  sums.of[2] = sums.of[2] + 0.48860251190291992 * z * all;
  sums.of[3] = sums.of[3] + 0.48860251190291992 * s * cos1;
  sums.of[4] = sums.of[4] + 0.54627421529603959 * s2 * sin2;
  sums.of[5] = sums.of[5] + 1.0925484305920792 * s * z * sin1;
  sums.of[6] = sums.of[6] + 0.31539156525252005 * (3.0 * z * z - 1.0) * all;
  sums.of[7] = sums.of[7] + 1.0925484305920792 * s * z * cos1;
  sums.of[8] = sums.of[8] + 0.54627421529603959 * s2 * cos2;
  return sums;
}

// The sum over the harmonics in each direction of the ring.
CloudRing ring_of(CloudMoments m, real z) {
  real s2 = 1.0 - z * z;
  real s = sqrt(s2);
  real all = 0.28209479177387814 * m.of[0] + 0.48860251190291992 * z * m.of[2] +
             0.31539156525252005 * (3.0 * z * z - 1.0) * m.of[6];
  real cos1 = s * (0.48860251190291992 * m.of[3] + 1.0925484305920792 * z * m.of[7]);
  real sin1 = s * (0.48860251190291992 * m.of[1] + 1.0925484305920792 * z * m.of[5]);
  real cos2 = kRoot * 0.54627421529603959 * s2 * m.of[8];
  real sin2 = kRoot * 0.54627421529603959 * s2 * m.of[4];
  real a = kCosine * cos1 + kSine * sin1;
  real b = kSine * cos1 + kCosine * sin1;
  real c = kCosine * sin1 - kSine * cos1;
  real d = kSine * sin1 - kCosine * cos1;
  real even0 = all + cos2 + sin2;
  real even1 = all - cos2 + sin2;
  real even2 = all - cos2 - sin2;
  real even3 = all + cos2 - sin2;
  CloudRing ring;
  ring.of[0] = even0 + a;
  ring.of[1] = even1 + b;
  ring.of[2] = even2 + c;
  ring.of[3] = even3 + d;
  ring.of[4] = even0 - a;
  ring.of[5] = even1 - b;
  ring.of[6] = even2 - c;
  ring.of[7] = even3 - d;
  return ring;
}
