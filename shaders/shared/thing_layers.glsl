// The layers of a picture of things, the air up to which the includer finds. What mirrors show counts as light of the
// surface.

#define Gathered LightLayers

LightLayers nothing_gathered() { return no_layers(); }

LightLayers with_air(LightLayers sum, SkyFactors air, float nu, vec3 through, bool first) {
  Phases p = phases(nu);
  if (!first) {
    sum.ground += through * phased(air, p) * scene.sun.irradiance;
    return sum;
  }
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    sum.single[i] = air.single[i] * p.of[i] * scene.sun.irradiance;
  }
  sum.multiple = air.diffuse * scene.sun.irradiance;
  sum.transmittance = beam_transmittance(air);
  return sum;
}

LightLayers with_light(LightLayers sum, vec3 light) {
  sum.ground += light;
  return sum;
}

#include "shared/thing_rays.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = picture_ray(pixel);
  here = pixel;
  ThingPixel rays = thing_pixel(pixel, view);
  LightLayers sum = empty_layers();
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = ray_of_thing_pixel(pixel, view, rays, i);
    sum = with_share(sum, gathered_along(one.direction, rays.spread, rays.bare, steps), one.share);
  }
  write_layers(pixel, uvec2(width, height), view.inside, sum);
}
