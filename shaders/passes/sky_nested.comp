#version 460
#extension GL_GOOGLE_include_directive : require
// The view march with a march to the sun at each of its steps [N93, O05], one pixel a thread: no table at all, hence
// single scattering and a ground lit by the sun alone.
#include "shared/device.glsl"
#include "shared/nested_light.glsl"
#include "physics/sunlight.glsl"
#include "physics/march.glsl"
#include "shared/sky_output.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  Ray ray = air_ray(view.direction);
  PathRadiance path = march(scene.planet, scene.sun, ray, steps, kStepDistribution, 0.0);
  write_radiance(pixel, view.inside, path.radiance, path.transmittance);
}
