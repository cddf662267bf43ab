// Light of the night sky: from beyond the air by a map, from a shell of glowing air, and scattered by the air.
// All of it stands in one table, a picture of kNightSide x (kNightSide + 1) texels. From its top come
//   kNightSide rows of the radiance from beyond the air;
//   one row of the radiance that the air scatters, kNightSlopes texels above the horizon and as many below it, then
//   the radiance of the shell seen straight up and the irradiance on level ground.
// The includer defines before it:
//   vec3 night_table(real x, real y);   linear between texels, whose middles are whole numbers from 0 on
//   vec3 night_texel(uint x, uint y);   one of them

const real kAirglowAltitude = 90.0;

vec3 airglow_zenith() { return night_texel(2u * kNightSlopes, kNightSide); }
vec3 night_on_ground() { return night_texel(2u * kNightSlopes + 1u, kNightSide); }

// The shell's length along a ray over that at the zenith, from an altitude below it (van Rhijn 1921).
real van_rhijn(PlanetData planet, real h, real mu) {
  real altitude = kAirglowAltitude * optical_scale();
  real shell = (planet.ground_radius + h) / (planet.ground_radius + altitude);
  real square = shell * shell * (1.0 - mu * mu);
  return h < altitude ? inversesqrt(max(1.0 - square, 1e-6)) : 0.0;
}

// The zenith cosine of row i. Rows stand by the root of the cosine's distance from the horizon.
real night_slope_cosine(PlanetData planet, real h, uint i) {
  real horizon = horizon_mu(planet, h);
  real x = real(i % kNightSlopes) / real(kNightSlopes - 1u);
  return horizon + (i < kNightSlopes ? 1.0 - horizon : -1.0 - horizon) * x * x;
}

vec3 night_scattered_at(PlanetData planet, real h, real mu, bool ground) {
  real horizon = horizon_mu(planet, h);
  real share = ground ? (horizon - mu) / (1.0 + horizon) : (mu - horizon) / (1.0 - horizon);
  real x = sqrt(clamp(share, 0.0, 1.0)) * real(kNightSlopes - 1u);
  uint i = min(uint(x), kNightSlopes - 2u);
  uint first = i + (ground ? kNightSlopes : 0u);
  vec3 from = night_texel(first, kNightSide);
  return from + (night_texel(first + 1u, kNightSide) - from) * (x - real(i));
}

// North is up in the map, whatever way the camera looks.
vec3 night_beyond(vec3 direction) {
  vec2 point = octahedral_point(direction, octant_of(direction));
  return night_table((0.5 + 0.5 * point.x) * real(kNightSide - 1u), (0.5 + 0.5 * point.y) * real(kNightSide - 1u));
}

// Transmittance of the first `distance_` km of a ray, by midpoints.
vec3 night_through(PlanetData planet, Ray ray, real distance_) {
  vec3 depth = vec3(0.0);
  real width = distance_ / 16.0;
  for (uint i = 0u; i < 16u; i++) {
    RayPoint point = point_on_ray(planet, ray, (real(i) + 0.5) * width);
    depth = depth + extinction_over(max(point.h, 0.0), width * point.mu) * width;
  }
  return exp(-depth);
}

// What the camera sees of a thing in it. `through`, `all`: transmittance up to the thing, and of the whole ray as if it
// were not there; `level`: cosine between the thing's normal and the vertical. The thing is lit evenly from the half of
// the sky that it faces, and the air before it scatters its share of what the whole ray would.
vec3 night_on_surface(PlanetData planet, real h, vec3 direction, vec3 through, vec3 all, vec3 albedo, real level) {
  vec3 before = min((vec3(1.0) - through) / max(vec3(1.0) - all, vec3(1e-6)), vec3(1.0));
  vec3 air = night_scattered_at(planet, h, max(direction.y, horizon_mu(planet, h)), false) * before;
  return air + through * albedo * night_on_ground() * (0.5 * (1.0 + level) / kPi);
}

// What the camera sees of it in a direction where nothing stands before it but the planet.
vec3 night_along(PlanetData planet, real h, vec3 direction) {
  Ray ray = ray_in_atmosphere(planet, h, direction.y, 0.0, 0.0);
  vec3 through = ray.length_ < 0.0 ? vec3(1.0) : seen_transmittance(planet, ray.h, ray.mu);
  vec3 light = night_beyond(direction) + airglow_zenith() * van_rhijn(planet, h, direction.y);
  vec3 scattered = ray.length_ < 0.0 ? vec3(0.0) : night_scattered_at(planet, h, direction.y, ray.at_ground);
  return (ray.at_ground ? vec3(0.0) : light * through) + scattered;
}
