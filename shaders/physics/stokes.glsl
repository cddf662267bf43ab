// Q and U of a picture's light (polarisation.glsl says what they are). The meridian plane turns about the zenith, so a
// table of Q and U by this plane could not be interpolated there. Tables and sums therefore have them by the two axes of
// axes_across(), Q along the first, and hold U over the sine of the azimuth from the sun's: both are even in this azimuth.
// The includer defines:
//   bool stokes();  whether Q and U are asked for

// Unit vectors across a direction. The second is a right angle toward growing azimuth from the first.
struct Axes {
  vec3 first;
  vec3 second;
};

// A unit vector `axis` across `from`, turned with it the short way onto another direction.
vec3 turned_along(vec3 axis, vec3 from, vec3 onto) {
  return axis - (from + onto) * (dot(axis, onto) / max(1.0 + dot(from, onto), 1e-6));
}

// A level unit vector toward the azimuth of a direction; north where it has none.
vec3 level_toward(vec3 d) {
  real across = sqrt(d.x * d.x + d.z * d.z);
  return across > 0.0 ? vec3(d.x / across, 0.0, d.z / across) : vec3(0.0, 0.0, -1.0);
}

// The axes: level toward the sun's azimuth at the zenith and at the nadir, and thence turned onto the directions above
// and below level.
Axes axes_across(vec3 d, vec3 sun) {
  Axes axes;
  axes.first = turned_along(level_toward(sun), vec3(0.0, d.y >= 0.0 ? 1.0 : -1.0, 0.0), d);
  axes.second = cross(axes.first, d);
  return axes;
}

// Toward the ground in the meridian plane, at the zenith and the nadir as for directions of the same azimuth.
vec3 downward_across(vec3 d) {
  vec3 level = level_toward(d);
  return level * d.y - vec3(0.0, sqrt(d.x * d.x + d.z * d.z), 0.0);
}

// Zenith cosine up to which a ray knows its azimuth, which it has from its angle to the sun: 3.4 minutes off the zenith.
real most_steep() { return stokes() ? 1.0 - 5e-7 : 1.0; }

// The direction, or one so far off the zenith or nadir.
vec3 with_azimuth(vec3 d, vec3 sun) {
  const real least = 1e-3;
  if (d.x * d.x + d.z * d.z >= least * least) {
    return d;
  }
  vec3 level = d.x == 0.0 && d.z == 0.0 ? level_toward(sun) : level_toward(d);
  return level * least + vec3(0.0, d.y > 0.0 ? 1.0 : -1.0, 0.0) * sqrt(1.0 - least * least);
}

// Light by those axes, from light by the meridian plane; u over the sine in both. `c`: cosine of the azimuth from the
// sun's. `upward`: above level.
Stokes by_sun_axes(Stokes light, real c, bool upward) {
  real side = upward ? 1.0 : -1.0;
  Stokes turned;
  turned.i = light.i;
  turned.q = light.q * (2.0 * c * c - 1.0) - light.u * (side * 2.0 * c * (1.0 - c * c));
  turned.u = light.q * (side * 2.0 * c) + light.u * (2.0 * c * c - 1.0);
  return turned;
}

// Cosine and sine of the azimuth from the sun's.
vec2 azimuth_from_sun(vec3 d, vec3 sun) {
  vec3 a = level_toward(d);
  vec3 b = level_toward(sun);
  return vec2(a.x * b.x + a.z * b.z, a.z * b.x - a.x * b.z);
}

// Adds sunlight that dipoles scatter once: `dipoles` is what they scatter along the ray, over nu^2 + 1 (kDipole).
// `light`: its u over the sine; the result's is not.
Stokes with_sunlight(Stokes light, vec3 dipoles, vec3 d, vec3 sun) {
  Axes axes = axes_across(d, sun);
  real a = dot(sun, axes.first);
  real b = dot(sun, axes.second);
  light.q = light.q + dipoles * (b * b - a * a);
  light.u = light.u * azimuth_from_sun(d, sun).y - dipoles * (2.0 * a * b);
  return light;
}

// Q and U by another first axis across the direction.
Stokes by_axis(Stokes light, Axes axes, vec3 first) {
  real c = dot(first, axes.first);
  real s = dot(first, axes.second);
  Stokes other;
  other.i = light.i;
  other.q = light.q * (c * c - s * s) + light.u * (2.0 * c * s);
  other.u = light.u * (c * c - s * s) - light.q * (2.0 * c * s);
  return other;
}

// The axis of the camera's polarising filter, as it lies across a ray. The filter stands behind the lens, which turns
// what swings across a ray along with the ray.
vec3 filter_axis(CameraData camera, vec3 d) { return turned_along(camera.polariser, camera.forward, d); }
