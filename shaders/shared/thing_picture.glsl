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

layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

ViewRay ray_of_pixel(uvec2 pixel) { return pixel_ray(pixel); }

// The pixel at hand.
void render(ViewRay view, ThingPixel rays) {
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = ray_of_thing_pixel(here, view, rays, i);
    Gathered seen = gathered_along(one.direction, rays.spread, rays.bare, steps);
    radiance += one.share * seen.radiance;
    transmittance += one.share * seen.transmittance;
  }
  write_radiance(here, view.inside, radiance, transmittance);
}

#include "shared/thing_pixels.glsl"
