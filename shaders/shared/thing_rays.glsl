// Rays among things, from mirror to mirror, and by thing_pixel.glsl the rays whose mean is a pixel.
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
#include "shared/thing_pixel.glsl"
#ifdef AIRLIGHT_BLOCK_AIR
#include "shared/block_air.glsl"
#endif
#include "shared/thing_shares.glsl"
#include "shared/sky_caps.glsl"
#include "physics/things_light.glsl"
#ifdef AIRLIGHT_CLOUDS
#include "shared/cloud_surface.glsl"
#include "shared/cloud_map.glsl"
#endif

layout(constant_id = 36) const uint kSegments = 1u;  // most parts of a ray from mirror to mirror; light beyond is lost
layout(constant_id = 37) const uint kDiscShows = 1u;  // 1: the disc shows in mirrors

#ifdef AIRLIGHT_CLOUDS
// In the direction in which the camera sees where a mirror's ray comes to the nearest cloud above it.
CloudMapRay past_mirrored_clouds(Sight sight) {
  const float kLeastClimb = 0.02;
  float climb = dot(sight.direction, sight.from.up);
  float up = 0.0;
  for (uint i = kFields; i > 0u; i--) {
    float above = cloud_fields.values[i - 1u].base - sight.from.h;
    up = above > 0.0 ? above : up;
  }
  vec3 there = sight.from.point + sight.direction * (up / max(climb, kLeastClimb));
  return cloud_map_toward(climb > 0.0 && up > 0.0 ? normalize(there) : sight.direction);
}

// `shown`: light along a ray whose last part begins with `before` and leads to the sky or the ground. `through`: what
// is left of light from where that part begins.
vec3 with_clouds(vec3 shown, vec3 before, vec3 through, CloudMapRay past) {
  return before + through * past.sent + max(shown - before - through * past.taken, vec3(0.0)) * past.through;
}
#endif

uint met;  // of the ray at hand: what it meets first, and which of the bodies

// `spread`: angle between neighbouring rays. `bare`: no terrain before that distance along the ground.
Gathered gathered_along(vec3 direction, float spread, float bare, uint steps) {
  Gathered sum = nothing_gathered();
  vec3 origin = vec3(0.0);
  vec3 through = vec3(1.0);
  float beam = 0.0;  // width, km
  uint left = kNoBody;
  for (uint i = 0u; i < kSegments; i++) {
    Sight sight = sight_of(origin, direction);
    ThingHit hit = sky_alone();
    if (kTiles != kTilesOfSky) {
      hit = nearest_thing_past(scene.planet, sight, left, i == 0u ? bare : 0.0);
    }
    met = i == 0u ? hit.what + 8u * (hit.which + 1u) : met;
#ifdef AIRLIGHT_CLOUDS
    vec3 before = sum.light.i;
    vec3 left_before = through;
    CloudMapRay past = CloudMapRay(vec3(0.0), vec3(0.0), 1.0, 1.0);
    if (kSegments > 1u && i > 0u && !hits_thing(hit)) {
      past = past_mirrored_clouds(sight);
    }
#endif
    Ray ray = sight.ray;
    if (hits_thing(hit)) {
      real up_to = optical_length(scene.planet, sight.from.h, sight.track.mu, hit.distance_);
      ray = ray_up_to(scene.planet, sight.from.h, sight.track.mu, ray, up_to);
    }
#ifdef AIRLIGHT_BLOCK_AIR
    if (knows_air()) {
      KnownAir air = known_air(hit.what == kMeetsSky, hit.distance_, ray.length_);
      sum = with_light(sum, air.light);
      through = air.transmittance;
    } else
#endif
    {
      SkyFactors air = factors_past_things(sight, ray, steps);
      sum = with_air(sum, air, seen_cosine(scene.sun, ray.mu, ray.nu), through, i == 0u);
      through *= air.transmittance;
    }
#ifdef AIRLIGHT_CLOUDS
    sum.distance_ = i == 0u && hits_thing(hit) ? hit.distance_ : sum.distance_;
#endif
    if (hit.what == kMeetsSky) {
      bool disc = kDiscShows != 0u && i > 0u;
      vec3 sun = disc ? through * mirrored_disc(scene.sun, direction, spread) : vec3(0.0);
#ifdef AIRLIGHT_CLOUDS
      sum.light.i = with_clouds(sum.light.i, before, left_before, past);
      sun *= past.beam;
#endif
      sum = with_light(sum, sun);
      break;
    }
    if (kTiles == kTilesOfSky) {
      break;
    }
    beam += spread * hit.distance_;
    Surface surface = surface_at(scene.planet, scene.camera.altitude, sight, hit, beam);
    if (!surface.mirrors) {
      float share = sun_past_things(scene.planet, scene.camera.altitude, scene.sun, surface.place, hit.which);
      PlaceSun sun = sun_at(scene.planet, surface.place, scene.sun.direction);
      vec3 open = open_irradiance(scene.moments, sun, surface);
      float lit = 1.0;
#ifdef AIRLIGHT_CLOUDS
      lit = sun_past_cloud(surface.place, sun);
#endif
      SkyPast sky = sky_past_things(scene.planet, scene.moments, scene.camera.altitude, sun, surface, open, lit);
#ifdef AIRLIGHT_CLOUDS
      sky = sky_past_cloud(sky, surface, sun, lit, open);
#endif
      sum = with_light(sum, through * scene.sun.irradiance * surface_radiance(scene.planet, scene.moments, surface,
                                                                               direction, sun, share * lit, sky, open));
#ifdef AIRLIGHT_CLOUDS
      sum.light.i = with_clouds(sum.light.i, before, left_before, past);
#endif
      break;
    }
    through *= surface.ground.albedo;
    spread += 2.0 * beam / ball_of_body(hit.which).radius;
    origin = surface.place.point;
    direction = normalize(direction - surface.normal * (2.0 * dot(direction, surface.normal)));
    left = hit.which;
  }
  return sum;
}
