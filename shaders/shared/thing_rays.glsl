// Rays among things, from mirror to mirror, and the rays whose mean is a pixel.
// The includer defines, for what it gathers along a ray:
//   struct Gathered
//   Gathered nothing_gathered();
//   Gathered with_air(Gathered sum, SkyFactors air, float nu, vec3 through, bool first);  first: up to the first thing
//   Gathered with_light(Gathered sum, vec3 light);                                        of what the air ends at
// With AIRLIGHT_CLOUDS surfaces lie under a cloud, and it has a member
//   float distance_;  to the first thing; 0: none is met
#include "physics/surface_light.glsl"
#include "physics/terrain_light.glsl"
#include "physics/sphere_light.glsl"
#include "shared/thing_shares.glsl"
#include "physics/things_light.glsl"
#ifdef AIRLIGHT_CLOUDS
#include "shared/cloud_surface.glsl"
#endif

layout(constant_id = 36) const uint kSegments = 1u;  // most parts of a ray from mirror to mirror; light beyond is lost
layout(constant_id = 37) const uint kDiscShows = 1u;  // 1: the disc shows in mirrors

// `spread`: angle between neighbouring rays. `bare`: no terrain before that distance along the ground.
Gathered gathered_along(vec3 direction, float spread, float bare, uint steps) {
  Gathered sum = nothing_gathered();
  vec3 origin = vec3(0.0);
  vec3 through = vec3(1.0);
  float beam = 0.0;  // width, km
  uint left = kNoSphere;
  for (uint i = 0u; i < kSegments; i++) {
    Sight sight = sight_of(origin, direction);
    ThingHit hit = nearest_thing_past(scene.planet, sight, left, i == 0u ? bare : 0.0);
    Ray ray = sight.ray;
    if (hits_thing(hit)) {
      real up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, hit.distance_);
      ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, up_to);
    }
    SkyFactors air = factors_past_things(sight, ray, steps);
    sum = with_air(sum, air, seen_cosine(scene.sun, ray.mu, ray.nu), through, i == 0u);
    through *= air.transmittance;
#ifdef AIRLIGHT_CLOUDS
    sum.distance_ = i == 0u && hits_thing(hit) ? hit.distance_ : sum.distance_;
#endif
    if (hit.what == kMeetsSky) {
      bool disc = kDiscShows != 0u && i > 0u;
      sum = with_light(sum, disc ? through * mirrored_disc(scene.sun, direction, spread) : vec3(0.0));
      break;
    }
    beam += spread * hit.distance_;
    Surface surface = surface_at(scene.planet, scene.camera.altitude, sight, hit, beam);
    if (!surface.mirrors) {
      float share = sun_past_things(scene.planet, scene.camera.altitude, scene.sun, surface.place, hit.which);
      PlaceSun sun = sun_at(scene.planet, surface.place, scene.sun.direction);
      SkyPast sky = sky_past_things(scene.planet, scene.moments, scene.camera.altitude, sun, surface);
#ifdef AIRLIGHT_CLOUDS
      float lit = sun_past_cloud(surface.place, sun);
      sky = sky_past_cloud(sky, surface, sun, lit);
      share *= lit;
#endif
      sum = with_light(sum, through * scene.sun.irradiance *
                                surface_radiance(scene.planet, scene.moments, surface, direction, sun, share, sky));
      break;
    }
    through *= surface.ground.albedo;
    spread += 2.0 * beam / sphere(hit.which).radius;
    origin = surface.place.point;
    direction = normalize(direction - surface.normal * (2.0 * dot(direction, surface.normal)));
    left = hit.which;
  }
  return sum;
}

layout(scalar, set = 0, binding = 18) readonly buffer Corners { vec2 values[]; } corners;  // of the tile, row by row

const uint kEdgeSide = 4u;  // rays across a pixel with an edge, a shadow's edge or a mirror

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
  uint side;     // above 1: so many rays across, for a pixel with an edge
  uint count;
  float spread;  // angle between neighbouring rays
  float bare;    // no terrain before that distance along the ground, km
};

ThingPixel thing_pixel(uvec2 pixel, ViewRay view) {
  ThingPixel found;
  found.rays = rays_at(pixel, view);
  found.side = 1u;
  found.spread = 0.0;
  found.bare = 0.0;
  if (kProjection != kProjectionListed) {
    // Within the pixel, so as not to cross the cut of a map.
    float across = length(direction_at(pixel, vec2(0.99, 0.5)) - direction_at(pixel, vec2(0.01, 0.5)));
    float corner = length(direction_at(pixel, vec2(0.99, 0.99)) - direction_at(pixel, vec2(0.01, 0.01)));
    PixelCorners seen = corners_of(pixel);
    bool edge = holds_sphere_edge(view.direction, max(across, corner)) || holds_step(seen);
    found.bare = has_terrain() ? bare_before(seen, view.direction, edge) : 0.0;
    found.side = view.inside && edge ? kEdgeSide : 1u;
    found.spread = across / (0.98 * float(found.side));
  }
  found.count = found.side > 1u ? found.side * found.side : found.rays.count;
  return found;
}

WeightedRay ray_of_thing_pixel(uvec2 pixel, ViewRay view, ThingPixel of, uint i) {
  if (of.side == 1u) {
    return weighted_ray(pixel, view, of.rays, i);
  }
  WeightedRay ray;
  ray.direction = direction_at(pixel, (vec2(float(i % of.side), float(i / of.side)) + 0.5) / float(of.side));
  ray.share = 1.0 / float(of.count);
  return ray;
}
