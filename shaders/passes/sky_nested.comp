#version 460
#extension GL_GOOGLE_include_directive : require
// The view march with a march to the sun at each of its steps [N93, O05], one pixel a thread: no table at all, hence
// single scattering and a ground lit by the sun alone.
#include "shared/device.glsl"

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
vec3 fetch_multiple_scattering(real x, real y) { return vec3(0.0); }
bool ground_reflects() { return kGroundReflects != 0u; }
vec3 fetch_ground_irradiance(real x) { return vec3(0.0); }

#include "physics/sunlight.glsl"
#include "physics/march.glsl"
#include "shared/march_pixels.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = marched_ray(pixel);
  Ray ray = air_ray(view.direction);
  Upsampled from = upsampled(pixel, width, view.direction, ray.at_ground);
  // The march takes no step on a ray of no length.
  ray.length_ = from.holds ? -1.0 : ray.length_;
  PathRadiance path =
      march_at(scene.planet, scene.sun, ray, steps, kStepDistribution, place_in_step(pixel), 0.0);
  write_marched(pixel, width, view, ray.at_ground, from, path);
}
