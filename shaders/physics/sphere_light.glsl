// Light that a sphere sends back, for a sun of irradiance 1.

// Irradiance that a translucent sphere sends back for that of its surface: 0.3 of a matte one's plus 0.7 of its term by
// thickness, which is lit by `even`, the mean irradiance over all normals. `facing`: cosine of the way to the camera.
vec3 translucent_irradiance(SphereData s, vec3 irradiance, vec3 even, real facing) {
  real thickness = subsurface_thickness(clamp(facing, 0.0, 1.0));
  return irradiance * 0.3 + even * (0.7 * subsurface_share(thickness, s.scatter_strength));
}

// Radiance of the disc, W/(m2 sr), in a mirror whose ray stands for a cone that spreads by `spread`. The disc's light
// is spread over the sky that disc and cone take together, as a paraboloid with the disc's integral.
vec3 mirrored_disc(SunData sun, vec3 direction, real spread) {
  real square = sun.angular_radius * sun.angular_radius;
  real wide = square + 2.25 * spread * spread;
  vec3 off = direction - sun.seen;
  real x = dot(off, off) / wide;
  real mean = 1.0 - sun.limb_darkening / 3.0;
  return sun.disc_radiance * (x < 1.0 ? 2.0 * mean * square / wide * (1.0 - x) : 0.0);
}
