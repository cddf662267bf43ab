// What bodies hide of the sky: the mean light of a cap of the sphere of directions, as a table over where the cap lies
// and how large it is. The light is the sky's and the ground's at one place among the bodies, over its mean all around.
// It is even in the azimuth from the sun's, so a cap has three coordinates, each from 0 to 1:
//   x  sine of half the angle from the sun: 0 at the sun
//   y  around the sun, (1 + cosine of the turn from straight up) / 2
//   z  root of the sine of the cap's half-angle, which is radius over distance for a ball
// Block kCapLevel weights light as the irradiance of a level surface does, kCapAround as that of a small sphere.
// The includer defines:
//   vec3 fetch_cap(uint block, real x, real y, uint size);  at a listed size, of which there are kCapSizes

const uint kCapLevel = 0u;
const uint kCapAround = 1u;

struct CapPlace {
  real x;
  real y;
};

// `axis`, `up` and `sun` are unit vectors.
CapPlace cap_place(vec3 axis, vec3 up, vec3 sun) {
  real c = clamp(dot(axis, sun), -1.0, 1.0);
  real mu_sun = dot(up, sun);
  real sines = sqrt(max((1.0 - c * c) * (1.0 - mu_sun * mu_sun), 0.0));
  CapPlace place;
  place.x = sqrt(0.5 * (1.0 - c));
  place.y = 0.5 + 0.5 * clamp((dot(axis, up) - c * mu_sun) / max(sines, 1e-6), -1.0, 1.0);
  return place;
}

// `sine`: of the half-angle.
vec3 cap_light(uint block, CapPlace place, real sine) {
  real z = sqrt(min(sine, 1.0)) * real(kCapSizes - 1u);
  uint low = min(uint(z), kCapSizes - 2u);
  real part = z - real(low);
  return fetch_cap(block, place.x, place.y, low) * (1.0 - part) + fetch_cap(block, place.x, place.y, low + 1u) * part;
}

// Of the half of the sphere of directions around the opposite of the place's.
vec3 light_behind(CapPlace place) {
  return fetch_cap(kCapAround, sqrt(max(1.0 - place.x * place.x, 0.0)), 1.0 - place.y, kCapSizes - 1u);
}

// A direction by how it lies to the sun: cosine and sine of the angle from it, and of the turn from straight up.
struct AboutSun {
  real c;
  real s;
  real turn;
  real aside;
};

AboutSun cap_axis(CapPlace place) {
  AboutSun a;
  a.c = 1.0 - 2.0 * place.x * place.x;
  a.s = 2.0 * place.x * sqrt(max(1.0 - place.x * place.x, 0.0));
  a.turn = 2.0 * place.y - 1.0;
  a.aside = sqrt(max(1.0 - a.turn * a.turn, 0.0));
  return a;
}

// Directions that the light is summed over, in rings about the sun, the closer the nearer to it. The second half of a
// ring's turns mirrors the first.
struct CapRing {
  real c;  // as of AboutSun
  real s;
  real weight;  // solid angle of one of its directions
};

CapRing cap_ring(uint ring) {
  real from = real(ring) / real(kCapRings);
  real to = real(ring + 1u) / real(kCapRings);
  real x = 0.5 * (from + to);
  real angle = kPi * x * sqrt(x);
  CapRing r;
  r.c = cos(angle);
  r.s = sin(angle);
  r.weight = 2.0 * kPi / real(kCapSpokes) * (cos(kPi * from * sqrt(from)) - cos(kPi * to * sqrt(to)));
  return r;
}

AboutSun cap_direction(CapRing ring, uint spoke) {
  real turn = 2.0 * kPi * (real(spoke) + 0.5) / real(kCapSpokes);
  AboutSun a;
  a.c = ring.c;
  a.s = ring.s;
  a.turn = cos(turn);
  a.aside = sin(turn);
  return a;
}

real zenith_cosine(AboutSun a, real mu_sun) {
  return clamp(a.c * mu_sun + a.s * a.turn * sqrt(max(1.0 - mu_sun * mu_sun, 0.0)), -1.0, 1.0);
}

// Of the azimuth from the sun's.
real azimuth_cosine(AboutSun a, real mu_sun) {
  real mu = zenith_cosine(a, mu_sun);
  real toward = a.c * sqrt(max(1.0 - mu_sun * mu_sun, 0.0)) - a.s * a.turn * mu_sun;
  return clamp(toward / max(sqrt(1.0 - mu * mu), 1e-6), -1.0, 1.0);
}

// The straight line between two directions: 2 sin(angle / 2).
real chord_between(AboutSun a, AboutSun b) {
  real c = a.c * b.c + a.s * b.s * (a.turn * b.turn + a.aside * b.aside);
  return sqrt(max(2.0 - 2.0 * c, 0.0));
}

// Share of a direction's part of the sphere that lies within a cap. `chord`: to its axis, `rim`: from there to its rim.
real within_cap(real rim, real chord, real weight) {
  return clamp(0.5 + 0.5 * (rim - chord) / sqrt(weight / kPi), 0.0, 1.0);
}
