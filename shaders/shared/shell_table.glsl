// The table of the sun's light for air cut into shells, a sampler in the place of the transmittance table.

vec3 fetch_sun_table(real x, real y) { return fetch_transmittance(x, y); }

#include "physics/shells.glsl"
#include "physics/shell_march.glsl"

// `steps`: parts of each shell where the air is cut into shells.
SkyFactors scene_sky_factors(Ray ray, uint steps) {
  if (shell_rows() > 0u) {
    return shell_sky_factors(scene.planet, scene.moments, ray, steps);
  }
  return sky_factors(scene.planet, scene.moments, ray, steps);
}
