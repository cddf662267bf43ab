// The table of the sun's light for air cut into shells, a sampler in place of the transmittance table.

vec3 fetch_sun_table(real x, real y) { return fetch_transmittance(x, y); }

#include "physics/shells.glsl"
#include "physics/shell_march.glsl"

// `steps`: steps of the ray, or parts of each shell where the air is cut into shells.
SkyFactors scene_sky_factors(Ray ray, uint steps) {
  if (shell_rows() > 0u) {
    return shell_sky_factors(scene.planet, scene.moments, ray, steps);
  }
  return sky_factors(scene.planet, scene.moments, ray, steps);
}

// The factors of the air alone, whatever the ray ends on.
SkyFactors scene_air_factors(Ray ray, uint steps) {
  if (shell_rows() > 0u) {
    return shell_air_factors(scene.planet, scene.moments, ray, steps);
  }
  return air_factors(scene.planet, scene.moments, ray, steps);
}

// Light of the ground at the end of a ray that meets it, through air of this transmittance; else none.
vec3 scene_ground_light(Ray ray, vec3 transmittance) {
  if (!ray.at_ground || ray.length_ < 0.0) {
    return vec3(0.0);
  }
  if (shell_rows() > 0u) {
    return shell_ground_light(scene.planet, scene.moments, ray, transmittance);
  }
  return ground_light(scene.planet, scene.moments, ray, transmittance);
}

// Factors of the air, and the ground's light apart.
struct ApartFactors {
  SkyFactors air;
  vec3 ground;  // as the camera sees it
};

ApartFactors scene_apart_factors(Ray ray, uint steps) {
  ApartFactors apart;
  apart.air = scene_air_factors(ray, steps);
  apart.ground = scene_ground_light(ray, apart.air.transmittance);
  return apart;
}
