// The sky-view table [H20 sec. 5.3]: radiance as seen from one altitude inside the air, by azimuth from the sun (x) and
// by elevation above the true horizon or depression below it (y). Sky and ground have rows of their own, so that no
// fetch mixes the two.
// x: the chord sin(azimuth/2), dense around the sun. The sky is the same on both sides of the sun, hence even in the
// chord. The first column stands half a texel from azimuth 0, and clamping makes the other half its mirror image, so
// that interpolation crosses the sun's azimuth without a crease. The last column stands at azimuth 180 degrees exactly.
// y: the square root of the angle from the horizon, dense beside it. The first row of each part is the horizon, the
// last the zenith or the nadir.

// Texture coordinate of an even quantity from 0 to 1 in a table n texels wide, and back.
real texel_from_even(real x, real n) { return x * (n - 0.5) / n; }
real even_from_texel(real u, real n) { return u * n / (n - 0.5); }

// Texture coordinate of a unit quantity in `count` rows from row `first` on, of a table of n rows, and back.
real texel_in_part(real y, real first, real count, real n) { return (first + 0.5 + y * (count - 1.0)) / n; }
real part_from_texel(real v, real first, real count, real n) { return (v * n - 0.5 - first) / (count - 1.0); }

struct SkyViewCoordinate {
  real chord;   // sin(azimuth from the sun / 2), 0 to 1
  real height;  // square root of the angle from the horizon over its greatest value, 0 to 1
  bool ground;  // below the horizon
};

// Angle from the horizontal down to the true horizon.
real horizon_depression(PlanetData planet, real h) { return atan(horizon_distance(planet, h), planet.ground_radius); }

// The chord is computed from the distance of two unit vectors: an azimuth's cosine has no digits left beside the sun.
SkyViewCoordinate sky_view_coordinate(PlanetData planet, real h, vec3 view, vec3 sun) {
  real across = sqrt(view.x * view.x + view.z * view.z);
  real depression = horizon_depression(planet, h);
  real above = atan(view.y, across) + depression;
  // Straight up or down, or under a sun straight up, every azimuth is the same.
  vec3 a = vec3(view.x, 0.0, view.z) / max(across, 1e-12);
  vec3 b = vec3(sun.x, 0.0, sun.z) / max(sqrt(sun.x * sun.x + sun.z * sun.z), 1e-12);
  SkyViewCoordinate c;
  c.ground = meets_ground(planet, h, view.y);
  c.chord = clamp(0.5 * length(a - b), 0.0, 1.0);
  c.height = c.ground ? sqrt(clamp(-above / (0.5 * kPi - depression), 0.0, 1.0))
                      : sqrt(clamp(above / (0.5 * kPi + depression), 0.0, 1.0));
  return c;
}

// The ray of a texel. The rows of the horizon hold the tangent: to the top in the sky's part, else to the ground.
Ray sky_view_ray(PlanetData planet, real h, SkyViewCoordinate c, real mu_sun) {
  real depression = horizon_depression(planet, h);
  real square = c.height * c.height;
  real elevation = c.ground ? -square * (0.5 * kPi - depression) - depression
                            : square * (0.5 * kPi + depression) - depression;
  real cos_azimuth = 1.0 - 2.0 * c.chord * c.chord;
  Ray ray;
  ray.h = h;
  // Kept below 0 on the ground itself, where the ray to the ground has length 0.
  ray.mu = c.ground ? min(sin(elevation), -1e-9) : sin(elevation);
  ray.mu_sun = mu_sun;
  real across = cos(elevation) * sqrt(max(1.0 - mu_sun * mu_sun, 0.0));
  ray.nu = clamp(sin(elevation) * mu_sun + across * cos_azimuth, -1.0, 1.0);
  ray.at_ground = c.ground;
  ray.falls = c.ground;
  ray.length_ = c.ground ? distance_to_ground(planet, h, ray.mu) : distance_to_top(planet, h, ray.mu);
  return ray;
}
