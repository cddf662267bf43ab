// Light for the passes of `nested`: sunlight by a march to the sun, and no other.

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 5) const uint kGroundReflects = 0u;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
  uint sun_steps;
};

vec3 transmittance_to_top(PlanetData planet, real h, real mu) {
  return exp(-optical_depth_to_top(planet, h, mu, sun_steps));
}
real bending_along(PlanetData planet, real h, real mu) { return 0.0; }
vec3 fetch_multiple_scattering(real x, real y) { return vec3(0.0); }
bool ground_reflects() { return kGroundReflects != 0u; }
vec3 fetch_ground_irradiance(real x) { return vec3(0.0); }
