// The rays whose mean is a pixel of the tile at hand: one, but at the planet's edge.
#include "physics/horizon.glsl"

vec2 pixel_centre(uvec2 pixel) { return vec2(pixel.x + scene.tile.x, pixel.y + scene.tile.y) + 0.5; }

PixelRays rays_at(uvec2 pixel, ViewRay view) {
  PixelRays rays = one_ray(0.0);
  if (kProjection == kProjectionListed) {
    return rays;
  }
  // Most pixels are far from it: a cosine changes by less than its angle. Written as a loop of one turn or none: a
  // branch not taken still runs, masked, on a software device.
  float reach = pixel_reach(scene.camera, kProjection);
  float over = view.direction.y - horizon_mu(scene.planet, scene.camera.altitude);
  uint turns = over > -reach && over < 1.1 * air_edge(scene.planet, scene.camera.altitude) + reach ? 1u : 0u;
  vec2 at = pixel_centre(pixel);
  for (uint i = 0u; i < turns; i++) {
    rays = pixel_rays(scene.planet, scene.camera, kProjection, at.x, at.y, view.direction);
  }
  return rays;
}

struct WeightedRay {
  vec3 direction;
  float share;  // of the pixel
};

WeightedRay weighted_ray(uvec2 pixel, ViewRay view, PixelRays rays, uint i) {
  WeightedRay weighted;
  weighted.direction = view.direction;
  weighted.share = 1.0;
  // A loop, as rays_at() has one.
  uint turns = rays.count > 1u ? 1u : 0u;
  for (uint k = 0u; k < turns; k++) {
    PixelRay ray = ray_of_pixel(rays, i);
    vec2 at = pixel_centre(pixel);
    weighted.direction = pixel_direction(scene.planet, scene.camera, kProjection, at.x, at.y, ray);
    weighted.share = ray.share;
  }
  return weighted;
}
