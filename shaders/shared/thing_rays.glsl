// Rays among things, from mirror to mirror, and the rays whose mean is a pixel.
// The includer defines, for what it gathers along a ray:
//   struct Gathered
//   Gathered nothing_gathered();
//   Gathered with_air(Gathered sum, SkyFactors air, float nu, vec3 through, bool first);  first: up to the first thing
//   Gathered with_light(Gathered sum, vec3 light);                                        of what the air ends at
#include "physics/surface_light.glsl"
#include "physics/terrain_light.glsl"
#include "physics/sphere_light.glsl"
#include "physics/things_light.glsl"

layout(constant_id = 36) const uint kSegments = 1u;  // most parts of a ray from mirror to mirror; light beyond is lost
layout(constant_id = 37) const uint kDiscShows = 1u;  // 1: the disc shows in mirrors

// `spread`: angle between neighbouring rays.
Gathered gathered_along(vec3 direction, float spread, uint steps) {
  Gathered sum = nothing_gathered();
  vec3 origin = vec3(0.0);
  vec3 through = vec3(1.0);
  float beam = 0.0;  // width, km
  uint left = kNoSphere;
  for (uint i = 0u; i < kSegments; i++) {
    Sight sight = sight_of(origin, direction);
    ThingHit hit = nearest_thing(scene.planet, sight, left);
    Ray ray = sight.ray;
    if (hits_thing(hit)) {
      ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, hit.distance_);
    }
    SkyFactors air = factors_past_things(sight, ray, steps);
    sum = with_air(sum, air, ray.nu, through, i == 0u);
    through *= air.transmittance;
    if (hit.what == kMeetsSky) {
      bool disc = kDiscShows != 0u && i > 0u;
      sum = with_light(sum, disc ? through * mirrored_disc(scene.sun, direction, spread) : vec3(0.0));
      break;
    }
    beam += spread * hit.distance_;
    Surface surface = surface_at(scene.planet, scene.camera.altitude, sight, hit, beam);
    if (!surface.mirrors) {
      float share = sun_past_things(scene.planet, scene.camera.altitude, scene.sun, surface.place, hit.which);
      sum = with_light(sum, through * scene.sun.irradiance *
                                surface_radiance(scene.planet, scene.moments, surface, direction, scene.sun.direction, share));
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

// Whether the pixel's corners see terrain at distances too different to lie on one slope, or ground and terrain with
// different shares of the sun past spheres.
bool holds_step(uvec2 pixel) {
  float nearest = 1e9;
  float farthest = 0.0;
  float least = 1.0;
  float most = 0.0;
  for (uint i = 0u; i < 4u; i++) {
    vec3 direction = direction_at(pixel, vec2(i % 2u == 0u ? 0.01 : 0.99, i < 2u ? 0.01 : 0.99));
    Sight sight = sight_of(vec3(0.0), direction);
    TerrainHit terrain;
    terrain.hit = false;
    terrain.distance_ = 1e9;
    if (has_terrain()) {
      terrain = terrain_hit(scene.planet, sight.track);
    }
    bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
    float distance_ = terrain.hit ? terrain.distance_ : 1e9;
    nearest = min(nearest, distance_);
    farthest = max(farthest, distance_);
    vec3 point = direction * (terrain.hit ? terrain.distance_ : sight.before + sight.ray.length_);
    float share = sun_past_spheres(point, scene.sun.direction, scene.sun.angular_radius, kNoSphere);
    share = terrain.hit || ground ? share : 1.0;
    least = min(least, share);
    most = max(most, share);
  }
  return farthest > 1.15 * nearest || most - least > 0.1;
}

struct ThingPixel {
  PixelRays rays;
  uint side;     // above 1: so many rays across, for a pixel with an edge
  uint count;
  float spread;  // angle between neighbouring rays
};

ThingPixel thing_pixel(uvec2 pixel, ViewRay view) {
  ThingPixel found;
  found.rays = rays_at(pixel, view);
  found.side = 1u;
  found.spread = 0.0;
  if (kProjection != kProjectionListed) {
    // Within the pixel, so as not to cross the cut of a map.
    float across = length(direction_at(pixel, vec2(0.99, 0.5)) - direction_at(pixel, vec2(0.01, 0.5)));
    float corner = length(direction_at(pixel, vec2(0.99, 0.99)) - direction_at(pixel, vec2(0.01, 0.01)));
    bool edge = holds_sphere_edge(view.direction, max(across, corner)) || holds_step(pixel);
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
