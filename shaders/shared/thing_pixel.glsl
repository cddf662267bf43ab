// The rays whose mean is a pixel of a picture of things.
#include "shared/thing_light.h"

layout(constant_id = 38) const uint kTiles = kTilesAll;

layout(scalar, set = 0, binding = 18) readonly buffer Corners { vec2 values[]; } corners;  // of the tile, row by row

// Rays of a pixel with an edge, a shadow's edge or a mirror. No two share a row or a column of 8, so that an edge along
// either covers it in eight steps; as graphics hardware places its eight samples.
const uint kEdgeRays = 8u;
vec2 edge_place(uint i) {
  uvec2 at = (uvec2(0x75012634u, 0x07361452u) >> (4u * i)) & 7u;
  return (vec2(at) + 0.5) / float(kEdgeRays);
}

vec3 direction_at(uvec2 pixel, vec2 place) {
  vec2 at = vec2(pixel + uvec2(scene.tile.x, scene.tile.y)) + place;
  return view_ray(scene.camera, kProjection, at.x, at.y).direction;
}

// Whether the pixel, which extends by `reach` from its middle, holds a sphere's edge or a mirror.
bool holds_sphere_edge(vec3 direction, float reach) {
  bool edge = false;
  for (uint i = 0u; i < sphere_count(); i++) {
    SphereData s = sphere(i);
    float far = length(s.centre);
    float size = atan(s.radius, sqrt(max(far * far - s.radius * s.radius, 0.0)));
    float along = dot(direction, s.centre);
    float apart = atan(length(s.centre - direction * along), along);
    edge = edge || abs(apart - size) < reach || (s.material == kSphereMirror && apart < size);
  }
  return edge;
}

// What the corners of a pixel see (thing_corners.comp).
struct PixelCorners {
  float nearest;   // distances of terrain, km
  float farthest;
  float least;     // shares of the sun past spheres, of ground and terrain
  float most;
};

PixelCorners corners_of(uvec2 pixel) {
  uint row = scene.tile.width + 1u;
  uint first = pixel.y * row + pixel.x;
  vec2 a = corners.values[first];
  vec2 b = corners.values[first + 1u];
  vec2 c = corners.values[first + row];
  vec2 d = corners.values[first + row + 1u];
  PixelCorners of;
  of.nearest = min(min(a.x, b.x), min(c.x, d.x));
  of.farthest = max(max(a.x, b.x), max(c.x, d.x));
  of.least = min(min(a.y, b.y), min(c.y, d.y));
  of.most = max(max(a.y, b.y), max(c.y, d.y));
  return of;
}

// Whether the corners see terrain at distances too different to lie on one slope, or ground and terrain with different
// shares of the sun past spheres.
bool holds_step(PixelCorners of) { return of.farthest > 1.15 * of.nearest || of.most - of.least > 0.1; }

// Distance along the ground before which no ray of the pixel meets terrain.
float bare_before(PixelCorners of, vec3 direction, bool edge) {
  float before = edge ? 0.1 * of.nearest : of.farthest - of.nearest + terrain_shape().texel;
  return ground_distance(scene.planet, scene.camera.altitude, direction.y, max(of.nearest - before, 0.0));
}

struct ThingPixel {
  PixelRays rays;
  bool edge;     // of kEdgeRays rays
  uint count;
  float spread;  // angle between neighbouring rays
  float bare;    // no terrain before that distance along the ground, km
};

ThingPixel thing_pixel(uvec2 pixel, ViewRay view) {
  ThingPixel found;
  found.rays = rays_at(pixel, view);
  found.edge = false;
  found.spread = 0.0;
  found.bare = 0.0;
  if (kProjection != kProjectionListed && kTiles != kTilesOfSky) {
    // Within the pixel, so as not to cross the cut of a map.
    float across = length(direction_at(pixel, vec2(0.99, 0.5)) - direction_at(pixel, vec2(0.01, 0.5)));
    float corner = length(direction_at(pixel, vec2(0.99, 0.99)) - direction_at(pixel, vec2(0.01, 0.01)));
    PixelCorners seen = corners_of(pixel);
    bool edge = holds_sphere_edge(view.direction, max(across, corner)) || holds_step(seen);
    found.bare = has_terrain() ? bare_before(seen, view.direction, edge) : 0.0;
    found.edge = view.inside && edge;
    found.spread = across / (0.98 * (found.edge ? sqrt(float(kEdgeRays)) : 1.0));
  }
  found.count = found.edge ? kEdgeRays : found.rays.count;
  return found;
}

WeightedRay ray_of_thing_pixel(uvec2 pixel, ViewRay view, ThingPixel of, uint i) {
  if (!of.edge) {
    return weighted_ray(pixel, view, of.rays, i);
  }
  WeightedRay ray;
  ray.direction = direction_at(pixel, edge_place(i));
  ray.share = 1.0 / float(kEdgeRays);
  return ray;
}
