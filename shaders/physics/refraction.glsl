// Light bent by air whose refractive index n falls with altitude. With the optical altitude g, R' + g = n (R + h) and
// R' = n(0) R, Bouguer's law n (R + h) sin z = const says that the ray is straight: (R' + g) sin z = const. Zenith angles
// along it, the horizon and the depth of the air are then those of straight rays round a planet of radius R'. Two things
// differ. A stretch of the optical ray stands for 1/k = dh/dg of its length, so that densities are times dh/dg. And the
// ray goes further round the planet than the straight one, by the angle that it has been bent:
//   d bending = sin z / (R' + g) (n/k - 1) dt  along the optical ray.
// The sun's direction is the true one, above the air. A beam is spread by bending, and its irradiance falls.
//
// All optical lengths, R' among them, may be told in another unit: `scale` times as long. Near an altitude at which
// scale is dh/dg, a length in this unit is the true one, a true ray is straight there, and things stand where they are
// on a planet of radius R' = scale n(0) R. That is the surveyors' effective radius, R / (1 - R |dn/dh|).
// The includer defines:
//   bool bends_light();  real optical_top();  optical altitude of the top of the air
//   vec3 refraction_node(uint i);  real true_ground_radius();  of RefractionData
//   real optical_scale();  likewise, 1 where nothing is bent

// An altitude from its optical one.
struct TrueAltitude {
  real h;
  real stretch;  // dh/dg
};

uint refraction_cell(real g) {
  real u = sqrt(clamp(g / optical_top(), 0.0, 1.0)) * real(kRefractionCells);
  return min(uint(u), kRefractionCells - 1u);
}

// Cubic between nodes that stand at squares.
TrueAltitude true_altitude(real g) {
  TrueAltitude a;
  a.h = g;
  a.stretch = 1.0;
  if (bends_light()) {
    uint i = refraction_cell(g);
    vec3 low = refraction_node(i);
    vec3 high = refraction_node(i + 1u);
    real unit = optical_top() / real(kRefractionCells * kRefractionCells);
    real width = unit * real(2u * i + 1u);
    real x = clamp((g - unit * real(i * i)) / width, 0.0, 1.0);
    real rise = (high.x - low.x) / width;
    real bend = low.y + high.y - 2.0 * rise;
    real turn = 3.0 * rise - 2.0 * low.y - high.y;
    a.h = low.x + width * x * (low.y + x * (turn + x * bend));
    a.stretch = low.y + x * (2.0 * turn + x * 3.0 * bend);
  }
  return a;
}

// n/k - 1.
real bending_rate(PlanetData planet, real g) {
  TrueAltitude a = true_altitude(g);
  return (planet.ground_radius + g) / (true_ground_radius() + a.h) * a.stretch - 1.0;
}

// Bending along `length_` of a ray that leaves altitude g with zenith cosine mu >= 0.
real bending_upward(PlanetData planet, real g, real mu, real length_, uint steps) {
  Ray ray;
  ray.h = g;
  ray.mu = mu;
  ray.mu_sun = mu;
  ray.nu = 1.0;
  ray.bent = 0.0;
  ray.falls = false;
  real impact = (planet.ground_radius + g) * sqrt(max(1.0 - mu * mu, 0.0));
  real sum = 0.0;
  for (uint i = 0u; i < steps; i++) {
    // At cubes, so that no end of the midpoint rule counts.
    real x = (real(i) + 0.5) / real(steps);
    real h = point_on_ray(planet, ray, length_ * x * x * x).h;
    real q = planet.ground_radius + h;
    sum += x * x * bending_rate(planet, h) * impact / (q * q);
  }
  return sum * 3.0 * length_ / real(steps);
}

// Bending from altitude g along mu to the top of the air, in radians; the ground counts as air of its own altitude.
real bending_to_top(PlanetData planet, real g, real mu, uint steps) {
  if (mu >= 0.0) {
    return bending_upward(planet, g, mu, distance_to_top(planet, g, mu), steps);
  }
  real r = planet.ground_radius + g;
  real fall = r * mu * mu / (1.0 + sqrt(max(1.0 - mu * mu, 0.0)));
  real lowest = max(g - fall, 0.0);
  return bending_upward(planet, lowest, 0.0, distance_to_top(planet, lowest, 0.0), steps) +
         bending_upward(planet, lowest, 0.0, -r * mu, steps);
}

// Tables of sunlight have their edge at the horizon, where the sun rises for an observer who sees no bending. The sun
// that rises below it is looked up at mu + (1 - mu^2) lift, which is the horizon's zenith cosine as the sun rises.
real sun_lift(real g) {
  uint i = refraction_cell(g);
  real u = sqrt(clamp(g / optical_top(), 0.0, 1.0)) * real(kRefractionCells);
  real x = clamp(u - real(i), 0.0, 1.0);
  return refraction_node(i).z * (1.0 - x) + refraction_node(i + 1u).z * x;
}

real lifted_sun(real g, real mu_sun) {
  return bends_light() ? mu_sun + (1.0 - mu_sun * mu_sun) * sun_lift(g) : mu_sun;
}

// The inverse of lifted_sun().
real sun_before_lift(real g, real lifted) {
  real lift = sun_lift(g);
  return 2.0 * (lifted - lift) / (1.0 + sqrt(max(1.0 - 4.0 * lift * (lifted - lift), 0.0)));
}

// The sun as a point of the air sees it.
struct SeenSun {
  real mu;      // zenith cosine
  real spread;  // irradiance over that of the same beam unbent: n^2 times the solid angles' ratio
};

// n^2 sin(seen) d(seen) / (sin(true) d(true)); `bending`, and its derivative over the seen zenith angle. Far from a
// planet whose air bends light a beam may have met in a focus, where rays cross: its irradiance is bounded there.
real beam_spread(PlanetData planet, real g, real seen_mu, real bending, real derivative) {
  real n = (planet.ground_radius + g) / (true_ground_radius() + true_altitude(g).h) / optical_scale();
  real s = sqrt(max(1.0 - seen_mu * seen_mu, 0.0));
  real widening = max(1.0 + derivative, 1e-3);
  // sin(seen)/sin(true) as one quotient: both are 0 at the zenith, where bending is s times a number.
  real along = s > 1e-4 ? s / max(s * cos(bending) + seen_mu * sin(bending), 1e-6) : 1.0 / widening;
  return n * n * along / widening;
}

// The part of a falling ray above the altitude g, where the air bends little: its optical length, and the true one over
// it, the mean of dh/dg. 0 for a ray from below it, or one that does not fall so far.
struct ThinPart {
  real length_;
  real stretch;
};

ThinPart thin_part(PlanetData planet, Ray ray, real g) {
  real r = planet.ground_radius + ray.h;
  real c = (ray.h - g) * (planet.ground_radius + g + r);
  real q = r * r * ray.mu * ray.mu - c;
  bool falls = c > 0.0 && ray.mu < 0.0 && q > 0.0;
  ThinPart part;
  part.length_ = falls ? c / (sqrt(max(q, 0.0)) - r * ray.mu) : 0.0;
  part.stretch = (true_altitude(ray.h).h - true_altitude(g).h) / (falls ? ray.h - g : 1.0);
  return part;
}

// Optical length of the first `length_` km of a ray from altitude h, which may be in space, along mu.
real optical_length(PlanetData planet, real h, real mu, real length_) {
  const real kThin = 12.0;
  real before = air_entry(planet, h, mu).distance_;
  real inside = length_ - before / optical_scale();
  real optical = length_ * optical_scale();
  if (bends_light() && inside > 0.0) {
    Ray ray = ray_in_atmosphere(planet, h, mu, mu, 1.0);
    ThinPart thin = thin_part(planet, ray, kThin);
    real rest = inside - thin.length_ * thin.stretch;
    real first = true_altitude(point_on_ray(planet, ray, thin.length_).h).stretch;
    real t = rest / first;
    // Simpson's rule; each turn leaves a few hundredths of the error.
    UNROLL for (uint i = 0u; i < 2u; i++) {
      real middle = true_altitude(point_on_ray(planet, ray, thin.length_ + 0.5 * t).h).stretch;
      real last = true_altitude(point_on_ray(planet, ray, thin.length_ + t).h).stretch;
      t = rest * 6.0 / (first + 4.0 * middle + last);
    }
    optical = before + (rest > 0.0 ? thin.length_ + t : inside / thin.stretch);
  }
  return optical;
}

// The inverse of true_altitude(), by Newton's steps.
real optical_altitude_at(real h) {
  real g = h;
  if (bends_light()) {
    UNROLL for (uint i = 0u; i < 3u; i++) {
      TrueAltitude a = true_altitude(g);
      g += (h - a.h) / a.stretch;
    }
  }
  return g;
}

// The true vertical of a place with the vertical `up` on the planet of things: it stands as far from the camera, on a
// planet of another radius.
vec3 true_vertical(PlanetData planet, vec3 up) {
  if (!bends_light()) {
    return up;
  }
  real turn = planet.ground_radius / true_ground_radius();
  return normalize(vec3(up.x * turn, up.y, up.z * turn));
}

// The point with the sun as it stands there: the sun of a straight ray, turned by `bent`, the ray's bending up to
// there.
RayPoint with_turned_sun(RayPoint point, Ray ray, real bent) {
  real s = sqrt(max(1.0 - point.mu * point.mu, 1e-12));
  real ahead = (ray.nu - point.mu * point.mu_sun) / s;
  point.mu_sun = clamp(point.mu_sun * (1.0 - 0.5 * bent * bent) + ahead * bent, -1.0, 1.0);
  return point;
}

// A point at true distance t of a ray among things, with the sun as it stands there.
RayPoint sunlit_among_things(PlanetData planet, Ray ray, real t) {
  RayPoint point = point_on_ray(planet, ray, t);
  if (bends_light()) {
    real s = sqrt(max(1.0 - ray.mu * ray.mu, 0.0));
    real round = atan(t * s, planet.ground_radius + ray.h + t * ray.mu);
    point = with_turned_sun(point, ray, round * (planet.ground_radius / true_ground_radius() - 1.0));
  }
  return point;
}

// Cosine between the ray and the sun that with_turned_sun() has turned.
real turned_cosine(RayPoint point, Ray ray, real bent) {
  real s = sqrt(max(1.0 - point.mu * point.mu, 0.0));
  real ahead = (ray.nu - point.mu * point.mu_sun) / max(s, 1e-6);
  real up = point.mu_sun + ahead * bent;
  return clamp(ray.nu + point.mu * (up - point.mu_sun) - s * point.mu_sun * bent, -1.0, 1.0);
}

// Cosine between a camera ray in the air and the sun as the camera sees it, by which phase functions are taken: `mu` and
// `nu` are the ray's. The sun that a point of the air sees stands between this one and the true one.
real seen_cosine(SunData sun, real mu, real nu) {
  if (!bends_light()) {
    return nu;
  }
  real level = sqrt(max(1.0 - sun.direction.y * sun.direction.y, 1e-12));
  real seen_level = sqrt(max(1.0 - sun.seen.y * sun.seen.y, 0.0));
  return clamp(mu * sun.seen.y + (nu - mu * sun.direction.y) * (seen_level / level), -1.0, 1.0);
}
