#version 460
#extension GL_GOOGLE_include_directive : require
// night_sky.comp, with things before the sky, which its light shows.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/things.glsl"
#include "physics/terrain_light.glsl"
#include "shared/night_pixels.glsl"

vec3 night_light(vec3 direction) {
  real h = scene.camera.altitude;
  Sight sight = sight_of(vec3(0.0), direction);
  ThingHit hit = nearest_thing(scene.planet, sight, kNoBody);
  if (!hits_thing(hit)) {
    return night_along(scene.planet, h, direction);
  }
  Place place = place_at(scene.planet, h, direction * hit.distance_);
  vec3 normal = place.up;
  vec3 albedo = scene.planet.ground_albedo;
  if (hit.what == kMeetsBody) {
    normal = body_normal(hit.which, place.point);
    albedo = ball_of_body(hit.which).albedo;
  } else if (has_terrain()) {
    Slope slope = terrain_slope(track_east(sight.track, hit.ground), track_north(sight.track, hit.ground), place.up, 0.0);
    normal = slope.normal;
    albedo = slope.albedo;
  }
  float up_to = optical_length(scene.planet, h, sight.track.mu, hit.distance_);
  vec3 through = night_through(scene.planet, sight.ray, max(up_to - sight.before, 0.0));
  vec3 all = night_through(scene.planet, sight.ray, distance_to_top(scene.planet, sight.ray.h, sight.ray.mu));
  return night_on_surface(scene.planet, h, direction, through, all, albedo, dot(normal, place.up));
}
