// Light that a sphere sends back, for a sun of irradiance 1.

// A point's altitude and vertical. The point is given from the camera and lies in the planet's air.
struct SpherePlace {
  real h;  // altitude, km
  vec3 up;
};

SpherePlace sphere_place(PlanetData planet, real camera_altitude, vec3 point) {
  real r = planet.ground_radius + camera_altitude;
  real rise = 2.0 * r * point.y + dot(point, point);
  real r_there = sqrt(r * r + rise);
  SpherePlace place;
  place.h = clamp(camera_altitude + rise / (r_there + r), 0.0, planet.atmosphere_height);
  place.up = (point + vec3(0.0, r, 0.0)) / r_there;
  return place;
}

// The sky's irradiance on a surface with this normal.
vec3 sky_irradiance(MomentTableData table, SpherePlace place, vec3 normal, vec3 sun) {
  real mu = clamp(dot(normal, place.up), -1.0, 1.0);
  real mu_sun = dot(sun, place.up);
  vec3 level_normal = normal - place.up * mu;
  vec3 level_sun = sun - place.up * mu_sun;
  real lengths = length(level_normal) * length(level_sun);
  real cos_azimuth = lengths > 1e-7 ? clamp(dot(level_normal, level_sun) / lengths, -1.0, 1.0) : 1.0;
  return moment_irradiance(table, place.h, mu_sun, mu, cos_azimuth);
}

// Mean of the irradiance over all normals: a quarter of the light from all around, half of a hemisphere's if that is
// even.
vec3 mean_sky_irradiance(MomentTableData table, SpherePlace place, vec3 sun) {
  MomentCoordinate c = moment_coordinate(table, place.h, dot(sun, place.up));
  if (shell_rows() > 0u) {
    c.y = shell_coordinate(shell_of(place.h, true), place.h);
  }
  return exp(fetch_moment(0u, c.x, c.y)) * (kPi * 0.28209479177387814);
}

// Radiance of a sphere, not a mirror, seen along `direction`; `past`: share of the sun that other spheres leave. A
// translucent sphere is 0.3 of the matte one plus 0.7 of its term by thickness, which is lit by the mean over all
// normals.
vec3 sphere_radiance(PlanetData planet, MomentTableData table, SphereData s, SpherePlace place, vec3 normal,
                     vec3 direction, vec3 sun, real past) {
  vec3 direct = sun_through_air(planet, place.h, dot(sun, place.up)) * past;
  vec3 irradiance = direct * max(dot(normal, sun), 0.0) + sky_irradiance(table, place, normal, sun);
  if (s.material == kSphereTranslucent) {
    real thickness = subsurface_thickness(clamp(-dot(normal, direction), 0.0, 1.0));
    vec3 even = direct * 0.25 + mean_sky_irradiance(table, place, sun);
    irradiance = irradiance * 0.3 + even * (0.7 * subsurface_share(thickness, s.scatter_strength));
  }
  return s.albedo * irradiance / kPi;
}

// Radiance of the disc, W/(m2 sr), in a mirror whose ray stands for a cone that spreads by `spread`. The disc's light
// is spread over the sky that disc and cone take together, as a paraboloid with the disc's integral.
vec3 mirrored_disc(SunData sun, vec3 direction, real spread) {
  real square = sun.angular_radius * sun.angular_radius;
  real wide = square + 2.25 * spread * spread;
  vec3 off = direction - sun.direction;
  real x = dot(off, off) / wide;
  real mean = 1.0 - sun.limb_darkening / 3.0;
  return sun.disc_radiance * (x < 1.0 ? 2.0 * mean * square / wide * (1.0 - x) : 0.0);
}
