// What a cloud leaves of the light on the ground and on things.
#include "shared/cloud_balance.glsl"
#include "shared/cloud_stack.glsl"

// A place, from the camera, in the grid's units.
vec3 place_in_cloud(vec3 point) {
  float distance_ = max(length(point), 1e-6);
  return seen_in(cloud(), point / distance_, distance_);
}

OtherFields past_other_fields_at(Place place, PlaceSun sun) {
  float distance_ = max(length(place.point), 1e-6);
  return past_other_fields(place.point / distance_, distance_, place.h, sun.mu);
}

float sun_past_cloud(Place place, PlaceSun sun) {
  float shade = cloud_shade(place_in_cloud(place.point), place.h, sun.mu);
  if (kFields > 1u) {
    shade += past_other_fields_at(place, sun).shade;
  }
  return exp(-shade);
}

// The sky's light below the cloud is what the cloud lets through of all light, less what passes unscattered of the
// sun's and of light from about it, which the cloud shades at each place; it goes by the place (`falling_at`). As far
// as this is less than the clear sky's, the sky is dimmed; what is more comes evenly from above. Above the cloud the
// light that it sends up counts. `lit`: share of the sun past the cloud. `open`: what would come to the surface from
// sky and ground in the open. Among several fields the cloud is the highest.
SkyPast sky_past_cloud(SkyPast sky, Surface surface, PlaceSun sun, float lit, vec3 open) {
  float up = max(dot(sun.seen, surface.place.up), 0.0);
  vec3 direct = sun_through_air(scene.planet, 0.0, sun.mu) * up;
  vec3 clear = moment_ground_irradiance(scene.moments, sun.mu);
  CloudLight light = light_of_cloud();
  vec3 near_sun = min(direct * light.near_sun, clear);
  vec3 over = vec3(1.0);  // by the fields below the surface
  if (kFields > 1u) {
    OtherFields past = past_other_fields_at(surface.place, sun);
    light.below *= past.below;
    light.direct *= past.direct;
    over = past.over;
  }
  float about_sun = left_about_sun(highest_cloud(), surface.place.h, lit, light.direct, up);
  vec3 others = max((direct + clear) * light.below - (direct + near_sun) * light.direct, vec3(0.0));
  others *= falling_at(light, place_in_cloud(surface.place.point));
  vec3 below = others + near_sun * about_sun;
  vec3 more = max(others - (clear - near_sun), vec3(0.0));
  vec3 left = min(others / max(clear - near_sun, vec3(1e-20)), vec3(1.0));
  // On the surface, of light from about the sun, which comes as the sun's does.
  vec3 facing = near_sun * (max(dot(surface.normal, sun.seen), 0.0) / max(up, 1e-3));
  facing = min(facing, open) * (about_sun - left);
  // What the ground sends, beyond the share of a clear sky's that counts as left. Near the surface it lies in the same
  // shadow or gap of the cloud, far below it in many.
  const float kShadow = 0.3;  // km
  float lit_below = mix(lit, light.direct, surface.place.h / (surface.place.h + kShadow));
  vec3 from_ground = scene.planet.ground_albedo * (direct * lit_below + below - (direct + clear) * left);
  float height = clamp(place_in_cloud(surface.place.point).z, 0.0, 1.0);
  float upward = 0.5 + 0.5 * dot(surface.normal, surface.place.up);
  vec3 even = (facing + more * upward + from_ground * (1.0 - upward)) * sky.share;
  sky.share *= mix(left, light.air_above, height) * over;
  vec3 of_things = (direct * lit + below) / max(direct + clear, vec3(1e-20));  // the light on what sends `more`
  sky.more = sky.more * mix(of_things, vec3(1.0), height) + even * (1.0 - height);
  sky.more = max(sky.more, -open * sky.share);
  return sky;
}
