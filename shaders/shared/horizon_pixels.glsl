// The rays whose mean is a pixel of the tile at hand: one ray, several at the planet's edge.
#include "physics/horizon.glsl"

vec2 pixel_centre(uvec2 pixel) { return vec2(pixel.x + scene.tile.x, pixel.y + scene.tile.y) + 0.5; }

// Where a pixel is little work, the pixels at the edge are a pass of their own over a list. Code that is not run still
// takes its time on a software device, masked: it made a pass of one fetch twice as long.
layout(constant_id = 30) const uint kEdges = kEdgesFound;

PixelRays rays_at(uvec2 pixel, ViewRay view) {
  PixelRays rays = one_ray(0.0);
  if (kProjection == kProjectionListed || kEdges == kEdgesLeftOut) {
    return rays;
  }
  vec2 at = pixel_centre(pixel);
  float mu = view.direction.y;
  uint turns = mu > scene.camera.edge_low && mu < scene.camera.edge_high ? 1u : 0u;
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
  uint turns = rays.count > 1u ? 1u : 0u;
  for (uint k = 0u; k < turns; k++) {
    PixelRay ray = ray_of_pixel(rays, i);
    vec2 at = pixel_centre(pixel);
    weighted.direction = pixel_direction(scene.planet, scene.camera, kProjection, at.x, at.y, ray);
    weighted.share = ray.share;
  }
  return weighted;
}
