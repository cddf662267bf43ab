#version 460
#extension GL_GOOGLE_include_directive : require
// The layers of a picture by the march with a march to the sun inside, one pixel a thread.
#include "shared/device.glsl"
#include "shared/nested_light.glsl"
#include "physics/sunlight.glsl"
#include "physics/march.glsl"
#include "shared/layer_output.glsl"
#include "physics/march_layers.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  Ray ray = air_ray(view.direction);
  LightLayers layers = march_layers(scene.planet, scene.sun, ray, steps, kStepDistribution, 0.0);
  write_layers(pixel, uvec2(width, height), view.inside, layers);
}
