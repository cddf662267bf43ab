// What a picture shows of light from a direction, given by axes_across().

// A filter is given all light but its polarised part by half, as half the sun's irradiance (core/air/scene_block.cpp).
// Rounding of light that is wholly polarised must not leave less than nothing.
const float kFiltered = 1.0 - 1e-5;

Stokes shown(Stokes light, vec3 direction) {
  Axes axes = axes_across(direction, scene.sun.direction);
  if (kStokes == kStokesFiltered) {
    light.i += kFiltered * by_axis(light, axes, filter_axis(scene.camera, direction)).q;
    return light;
  }
  return by_axis(light, axes, downward_across(direction));
}

// The direction of the ray that tells the light from a direction.
vec3 ray_direction(vec3 direction) { return stokes() ? with_azimuth(direction, scene.sun.direction) : direction; }

Stokes with_share(Stokes sum, Stokes one, float share) {
  sum.i += share * one.i;
  if (kStokes == kStokesKept) {
    sum.q += share * one.q;
    sum.u += share * one.u;
  }
  return sum;
}

Stokes times(Stokes light, vec3 factor) {
  return Stokes(light.i * factor, light.q * factor, light.u * factor);
}
