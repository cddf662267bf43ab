// The air before a cloud on a pixel's ray, and the light of the cloud's stretches as it comes through that air to the
// camera.

const uint kMostSheets = 4u;    // stretches that the march puts aside
// km: a stretch so near to the one whose light's colour was found last has that colour. Among several fields each is
// found: their shadows are narrower.
const float kSameColour = 1.0;

#include "shared/cloud_ray_light.glsl"

struct Walk {
  vec3 light;     // so far, as the camera sees it
  ShadedAir shaded;  // where kAirByRay is 1
  vec3 air;       // of the air up to the last stretch
  vec3 seen;      // of it, what the cloud lets through
  float reach;    // sum of distances times the cloud's light taken out
  float transmittance;
  CloudColour colour;
};

Walk begun_walk() {
  Walk walk;
  walk.light = vec3(0.0);
  walk.shaded = no_shaded_air();
  walk.air = vec3(0.0);
  walk.seen = vec3(0.0);
  walk.reach = 0.0;
  walk.transmittance = 1.0;
  walk.colour.t = -1.0;
  walk.colour.sun = vec3(0.0);
  walk.colour.more = vec3(0.0);
  walk.colour.sky = vec3(0.0);
  walk.colour.ground = vec3(0.0);
  return walk;
}

// The walk up to a distance, and the air before it.
struct Stop {
  Walk walk;
  Before before;
  vec3 clear;  // light of the air before it if there were no cloud
};

Stop stop_at(Walk walk, AirRay of, float distance_) {
  Stop stop;
  if (kAirByRay == 1u) {
    walk.shaded = further(walk.shaded, of, distance_);
    stop.clear = walk.shaded.clear.once + walk.shaded.clear.more;
    stop.before.light = walk.shaded.left;
    stop.before.transmittance = segment_transfer(walk.shaded.clear.depth).through;
  } else {
    ClearAir air = clear_air_up_to(of.ray, of.at, optical_up_to(of.ray, distance_));
    stop.clear = air.once + air.more;
    stop.before.light = stop.clear * share_by_froxels(of, distance_);
    stop.before.transmittance = segment_transfer(air.depth).through;
  }
  stop.walk = walk;
  return stop;
}

// Stretches in turn from the camera.
struct Sheets {
  CloudGathered of[kMostSheets];
  uint count;
};

Walk with_sheets(Walk walk, Sheets sheets, AirRay of) {
  for (uint i = 0u; i < sheets.count; i++) {
    CloudGathered g = sheets.of[i];
    float t = g.reach / (g.before - g.transmittance);
    Stop stop = stop_at(walk, of, t);
    walk = stop.walk;
    if (kFields > 1u || walk.colour.t < 0.0 || abs(t - walk.colour.t) > kSameColour) {
      walk.colour = colour_at(of, t);
    }
    vec3 light = coloured(g, walk.colour, sun_past_things_at(of, t));
    vec3 air = max(stop.before.light - walk.air, vec3(0.0));
    walk.seen += air * g.before;
    walk.light += air * g.before + stop.before.transmittance * light;
    walk.air = max(stop.before.light, walk.air);
    walk.reach += g.reach;
  }
  return walk;
}
