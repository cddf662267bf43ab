// Distances and directions on a sphere with an atmosphere, from altitude h (km) and zenith cosine mu.
// Altitude is the state, never the radius: at 1 m r*r - R*R loses 2.9 % of the horizon's distance in 32 bits; h*(2R+h)
// 0.

// Distance to the horizon from altitude h.
real horizon_distance(PlanetData planet, real h) { return sqrt(h * (2.0 * planet.ground_radius + h)); }

// Zenith cosine of the true horizon, in -1 to 0. A direction below it meets the ground; the tangent does not.
real horizon_mu(PlanetData planet, real h) { return -horizon_distance(planet, h) / (planet.ground_radius + h); }

// Whether the planet hides direction mu from altitude h. At h = 0 it hides every direction below the plane, at distance
// 0, so that no ray from the ground runs through the planet.
bool meets_ground(PlanetData planet, real h, real mu) { return mu < horizon_mu(planet, h); }

// Distance to the top of the atmosphere from inside, never clipped by the ground. mu > 0 takes the rearranged root: the
// textbook root is wrong by 0.7 % at 99.9 km in 32 bits.
real distance_to_top(PlanetData planet, real h, real mu) {
  real r = planet.ground_radius + h;
  real gap = planet.atmosphere_height - h;
  real c = max(gap * (2.0 * planet.ground_radius + planet.atmosphere_height + h), 0.0);
  real root = sqrt(r * r * mu * mu + c);
  return mu > 0.0 ? c / (root + r * abs(mu)) : root - r * mu;
}

// Distance to the ground for a direction with meets_ground(); 0 from a start on the ground.
real distance_to_ground(PlanetData planet, real h, real mu) {
  real r = planet.ground_radius + h;
  real c = h * (2.0 * planet.ground_radius + h);
  return c / (sqrt(max(r * r * mu * mu - c, 0.0)) - r * mu);
}

// Distance from altitude h, which may be in space, to the ground or else to the point where the ray leaves the air. It
// is negative for a ray that meets neither.
real distance_to_end(PlanetData planet, real h, real mu) {
  if (meets_ground(planet, h, mu)) {
    return distance_to_ground(planet, h, mu);
  }
  if (h <= planet.atmosphere_height) {
    return distance_to_top(planet, h, mu);
  }
  real r = planet.ground_radius + h;
  real c = (h - planet.atmosphere_height) * (r + planet.ground_radius + planet.atmosphere_height);
  real discriminant = r * r * mu * mu - c;
  return mu < 0.0 && discriminant > 0.0 ? sqrt(discriminant) - r * mu : -1.0;
}

// A ray inside the atmosphere: where it starts, where it looks, where the sun stands, and how far it runs.
struct Ray {
  real h;         // altitude of the start
  real mu;        // zenith cosine of the view there
  real mu_sun;    // zenith cosine of the sun there
  real nu;        // cosine between view and sun
  real length_;   // to the ground or to the top; negative: the ray misses the air
  bool at_ground; // ends on the ground
  real bent;      // bending_ahead() at the start (sunlight.glsl), once lit_ray() has set it
  bool falls;     // its line meets the ground, which a thing may hide
};

// One point of a ray.
struct RayPoint {
  real h;
  real mu;
  real mu_sun;
};

// h + q/(r' + r) with q = t(2 r mu + t) is accurate to 0.03 m in 32 bits, sqrt(r*r + q) - R only to 0.5 m.
RayPoint point_on_ray(PlanetData planet, Ray ray, real t) {
  real r = planet.ground_radius + ray.h;
  real q = t * (2.0 * r * ray.mu + t);
  real squared = max(r * r + q, 1e-30);
  real inverse = inversesqrt(squared);
  RayPoint point;
  point.h = clamp(ray.h + q / (squared * inverse + r), 0.0, planet.atmosphere_height);
  point.mu = clamp((r * ray.mu + t) * inverse, -1.0, 1.0);
  point.mu_sun = clamp((r * ray.mu_sun + t * ray.nu) * inverse, -1.0, 1.0);
  return point;
}

// The point where a ray from altitude h, which may be in space, enters the air.
struct AirEntry {
  bool misses;     // the ray meets no air
  real distance_;  // from its start, 0 inside the air
  real root;       // from space: distance to the point of entry from the ray's lowest point
};

// Branches ask for the ray, too: Mesa's software device would simplify a shader once more at each start, to try what a
// branch on the camera's altitude alone leaves, which took 4 % of a picture of things.
AirEntry air_entry(PlanetData planet, real h, real mu) {
  AirEntry entry;
  bool is_in_space = h > planet.atmosphere_height;
  bool falls = mu < 0.0;
  entry.misses = is_in_space;
  entry.distance_ = 0.0;
  entry.root = 0.0;
  if (is_in_space && falls) {
    real r = planet.ground_radius + h;
    real c = (h - planet.atmosphere_height) * (r + planet.ground_radius + planet.atmosphere_height);
    real discriminant = r * r * mu * mu - c;
    entry.misses = discriminant <= 0.0;
    entry.root = sqrt(max(discriminant, 0.0));
    entry.distance_ = entry.misses ? 0.0 : c / (entry.root - r * mu);
  }
  return entry;
}

// The part inside the atmosphere of the ray from altitude h >= 0, which may be in space. length_ < 0 for a ray that
// misses the air or looks away from the planet.
Ray ray_in_atmosphere(PlanetData planet, real h, real mu, real mu_sun, real nu) {
  Ray ray;
  ray.h = h;
  ray.mu = mu;
  ray.mu_sun = mu_sun;
  ray.nu = nu;
  ray.length_ = -1.0;
  ray.at_ground = meets_ground(planet, h, mu);
  ray.falls = ray.at_ground;
  ray.bent = 0.0;
  bool is_in_space = h > planet.atmosphere_height;
  bool falls = mu < 0.0;
  bool misses = is_in_space;
  if (is_in_space && falls) {
    AirEntry entry = air_entry(planet, h, mu);
    misses = entry.misses;
    real r_top = planet.ground_radius + planet.atmosphere_height;
    real mu_sun_there = clamp(((planet.ground_radius + h) * mu_sun + entry.distance_ * nu) / r_top, -1.0, 1.0);
    ray.h = misses ? h : planet.atmosphere_height;
    ray.mu = misses ? mu : clamp(-entry.root / r_top, -1.0, 0.0);
    ray.mu_sun = misses ? mu_sun : mu_sun_there;
    ray.at_ground = meets_ground(planet, ray.h, ray.mu);
    ray.falls = ray.at_ground;
  }
  if (ray.at_ground) {
    ray.length_ = distance_to_ground(planet, ray.h, ray.mu);
  } else if (!misses) {
    ray.length_ = distance_to_top(planet, ray.h, ray.mu);
  }
  return ray;
}

// The same ray cut at a thing at `distance_` from the camera; h and mu are the camera's. A thing below the ground
// counts as standing on it. A thing before the air leaves a ray of length 0.
Ray ray_up_to(PlanetData planet, real h, real mu, Ray ray, real distance_) {
  real inside = distance_ - air_entry(planet, h, mu).distance_;
  if (ray.length_ >= 0.0 && inside < ray.length_) {
    ray.length_ = max(inside, 0.0);
    ray.at_ground = false;
  }
  return ray;
}

// Sine of a direction's angle above the true horizon from altitude h. It is computed as the sine of a difference: from
// space the zenith cosines lie so close together that their own difference would lose digits.
real above_horizon(PlanetData planet, real h, vec3 direction) {
  real sigma = sqrt(direction.x * direction.x + direction.z * direction.z);
  return direction.y * (planet.ground_radius / (planet.ground_radius + h)) - sigma * horizon_mu(planet, h);
}

// A point near the camera, its altitude and vertical. At the camera they are exact.
struct Place {
  vec3 point;  // from the camera
  real h;      // km
  vec3 up;
};

// Angle between unit vectors, to full precision at any angle.
real angle_between(vec3 a, vec3 b) { return 2.0 * atan(length(a - b), length(a + b)); }

Place place_at(PlanetData planet, real camera_altitude, vec3 point) {
  real r = planet.ground_radius + camera_altitude;
  real rise = 2.0 * r * point.y + dot(point, point);
  real lift = rise / (sqrt(r * r + rise) + r);
  Place place;
  place.point = point;
  place.h = max(camera_altitude + lift, 0.0);
  place.up = vec3(0.0, 1.0, 0.0) + (point - vec3(0.0, lift, 0.0)) / (r + lift);
  return place;
}

// A vector of the camera's frame as a place with the vertical `up` has it, x east, y up, -z north: turned along the
// great circle between the two.
vec3 to_level(vec3 up, vec3 v) {
  vec3 sum = up + vec3(0.0, 1.0, 0.0);
  return v - sum * (dot(sum, v) / (1.0 + up.y)) + vec3(0.0, 2.0 * dot(up, v), 0.0);
}

// to_level()'s inverse.
vec3 from_level(vec3 up, vec3 v) {
  vec3 sum = up + vec3(0.0, 1.0, 0.0);
  return v - sum * (dot(sum, v) / (1.0 + up.y)) + up * (2.0 * v.y);
}
