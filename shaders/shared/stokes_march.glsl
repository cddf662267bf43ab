// What a picture shows of a marched ray's light from a direction, for a sun of irradiance 1.
#include "shared/stokes_shown.glsl"

Stokes shown_along(SkyFactors factors, float nu, vec3 direction) {
  if (stokes()) {
    return shown(stokes_along(factors, phases(nu), direction, scene.sun.direction), direction);
  }
  Stokes light = no_light();
  light.i = phased(factors, phases(nu));
  return light;
}
