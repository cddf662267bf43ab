// The pixels of a picture of things, the air up to which the includer finds (factors_past_things()).

struct Gathered {
  vec3 radiance;
  vec3 transmittance;  // up to the first thing
};

Gathered nothing_gathered() { return Gathered(vec3(0.0), vec3(1.0)); }

Gathered with_air(Gathered sum, SkyFactors air, float nu, vec3 through, bool first) {
  sum.radiance += through * phased(air, phases(nu)) * scene.sun.irradiance;
  sum.transmittance = first ? beam_transmittance(air) : sum.transmittance;
  return sum;
}

Gathered with_light(Gathered sum, vec3 light) {
  sum.radiance += light;
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
  ViewRay view = pixel_ray(pixel);
  here = pixel;
  ThingPixel rays = thing_pixel(pixel, view);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = ray_of_thing_pixel(pixel, view, rays, i);
    Gathered seen = gathered_along(one.direction, rays.spread, rays.bare, steps);
    radiance += one.share * seen.radiance;
    transmittance += one.share * seen.transmittance;
  }
  write_radiance(pixel, view.inside, radiance, transmittance);
}
