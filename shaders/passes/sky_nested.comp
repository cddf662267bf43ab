#version 460
#extension GL_GOOGLE_include_directive : require
// The view march with a march to the sun at each of its steps [N93, O05], one pixel a thread: no table at all, hence
// single scattering and a ground lit by the sun alone.
#include "shared/device.glsl"
#include "shared/nested_light.glsl"
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
