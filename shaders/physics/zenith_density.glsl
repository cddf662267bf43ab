// A closed-form sky, `zenith-density`. The air is one even layer whose density along a ray is a fit in its zenith
// cosine. The sun's slant through the same layer absorbs, and each medium's phase function adds the forward glow.
// The includer defines what analytic.glsl asks for, and also: vec3 horizon_mass();  real lit_height();

// Slant over vertical optical depth of a layer on a sphere, mu >= 0: 1 straight up, `horizon` along the horizontal.
vec3 slant_mass(vec3 horizon, real mu) { return horizon / (vec3(1.0) + (horizon - vec3(1.0)) * mu); }

// Slant toward a sun that may stand below the horizontal: down to the lowest point and up again.
vec3 sun_slant_mass(vec3 horizon, real mu_sun) {
  vec3 up = slant_mass(horizon, abs(mu_sun));
  return mu_sun < 0.0 ? 2.0 * horizon - up : up;
}

PathRadiance analytic_zenith_density(PlanetData planet, SunData sun, Ray ray) {
  PathRadiance path;
  path.radiance = vec3(0.0);
  path.transmittance = vec3(1.0);
  if (ray.length_ < 0.0) {
    return path;
  }
  Phases p = phases(ray.nu);
  vec3 depth = vec3(0.0);      // along the vertical through the layer
  vec3 sun_depth = vec3(0.0);  // along the vertical above the layer's lower end
  vec3 glow = vec3(0.0);       // scattering column times phase function
  vec3 scattering = vec3(0.0);
  for (uint i = 0u; i < medium_count(); i++) {
    AnalyticMedium a = analytic_medium(i);
    real above = column_above(a, ray.h);
    real column = ray.at_ground ? column_above(a, 0.0) - above : above;
    depth = depth + extinction_of(i) * column;
    sun_depth = sun_depth + extinction_of(i) * (ray.at_ground ? column_above(a, 0.0) : above);
    scattering = scattering + medium(i).scattering * column;
    glow = glow + medium(i).scattering * (column * p.of[i]);
  }
  vec3 mass = slant_mass(horizon_mass(), abs(ray.mu));
  vec3 view_slant = depth * mass;
  vec3 sun_slant = sun_depth * sun_slant_mass(horizon_mass(), ray.mu_sun);
  // A set sun lights the part of the layer above the planet's shadow, which lies behind the dark part.
  real sunk = min(ray.mu_sun - horizon_mu(planet, ray.h), 0.0);
  real lit = exp(min(lowest_altitude(planet, 0.0, sunk), 0.0) / lit_height());
  vec3 near_sun = ray.at_ground ? max(sun_slant - view_slant, vec3(0.0)) : view_slant * (1.0 - lit) + sun_slant;
  vec3 far_sun = ray.at_ground ? view_slant + sun_slant : view_slant;
  vec3 diffuse_far = ray.at_ground ? analytic_diffuse().ground : analytic_diffuse().far;
  vec3 single = glow * mass * mean_exponential3(near_sun, far_sun) * lit;
  vec3 diffuse = scattering * mass * mean_exponential3(-analytic_diffuse().near, view_slant - diffuse_far);
  path.transmittance = exp(-view_slant);
  path.radiance = single + diffuse;
  if (ray.at_ground) {
    vec3 irradiance = exp(-sun_slant) * max(ray.mu_sun, 0.0) + exp(analytic_diffuse().irradiance);
    path.radiance = path.radiance + path.transmittance * planet.ground_albedo * irradiance / kPi;
  }
  path.radiance = path.radiance * sun.irradiance;
  return path;
}
