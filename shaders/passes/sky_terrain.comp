#version 460
#extension GL_GOOGLE_include_directive : require
// Terrain, the ground and the air before and behind them, with the terrain's shadow in the air: the view march on the
// table of moments along each pixel's ray. A pixel with an edge is the mean over rays through all of it.
#define AIRLIGHT_SUN_SHARE
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/moment_table.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/terrain_maps.glsl"
#include "shared/terrain_light_maps.glsl"
#include "physics/terrain.glsl"

layout(constant_id = 28) const uint kShafts = 1u;  // 0: the air is lit as if there were no terrain

#include "shared/terrain_march.glsl"
#include "physics/surface_light.glsl"
#include "physics/terrain_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
  float shadow_end;  // km along the ground from the camera beyond which no shadow is known
};

const uint kEdgeSide = 4u;  // rays across a pixel that holds an edge

struct Seen {
  vec3 radiance;
  vec3 transmittance;
};

Seen seen_along(vec3 direction, float pixel) {
  current_track = ground_track(scene.camera.altitude, direction);
  TerrainHit hit = terrain_hit(scene.planet, current_track);
  Ray ray = air_ray(direction);
  float before = air_entry(scene.planet, scene.camera.altitude, direction.y).distance_;
  if (hit.hit) {
    ray = ray_up_to(scene.planet, scene.camera.altitude, direction.y, ray, hit.distance_);
  }
  SkyFactors factors = terrain_factors(ray, direction, before, shadow_end, steps, max(steps / 2u, 1u));
  Seen seen;
  seen.radiance = phased(factors, phases(ray.nu));
  seen.transmittance = beam_transmittance(factors);
  if (hit.hit) {
    seen.radiance += factors.transmittance * terrain_radiance(scene.planet, scene.moments, scene.sun.direction,
                                                              current_track, hit.ground, hit.distance_ * pixel);
  }
  return seen;
}

vec3 direction_at(uvec2 pixel, vec2 place) {
  return view_ray(scene.camera, kProjection, float(pixel.x + scene.tile.x) + place.x,
                  float(pixel.y + scene.tile.y) + place.y).direction;
}

// Whether the pixel's corners see things at distances too different to lie on one slope.
bool holds_edge(uvec2 pixel) {
  float nearest = 1e9;
  float farthest = 0.0;
  for (uint i = 0u; i < 4u; i++) {
    vec3 direction = direction_at(pixel, vec2(i % 2u == 0u ? 0.05 : 0.95, i < 2u ? 0.05 : 0.95));
    TerrainHit hit = terrain_hit(scene.planet, ground_track(scene.camera.altitude, direction));
    float distance_ = hit.hit ? hit.distance_ : 1e9;
    nearest = min(nearest, distance_);
    farthest = max(farthest, distance_);
  }
  return farthest > 1.15 * nearest;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  bool listed = kProjection == kProjectionListed;
  float angle = 0.0;
  uint side = 1u;
  if (!listed) {
    angle = length(direction_at(pixel, vec2(1.0, 0.5)) - direction_at(pixel, vec2(0.0, 0.5)));
    side = view.inside && holds_edge(pixel) ? kEdgeSide : 1u;
  }
  PixelRays rays = rays_at(pixel, view);
  uint count = side > 1u ? side * side : rays.count;
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < count; i++) {
    WeightedRay one;
    if (side > 1u) {
      one.direction = direction_at(pixel, (vec2(float(i % side), float(i / side)) + 0.5) / float(side));
      one.share = 1.0 / float(count);
    } else {
      one = weighted_ray(pixel, view, rays, i);
    }
    Seen seen = seen_along(one.direction, angle / float(side));
    radiance += one.share * seen.radiance;
    transmittance += one.share * seen.transmittance;
  }
  write_radiance(pixel, view.inside, radiance * scene.sun.irradiance, transmittance);
}
