// The air before a cloud on a pixel's ray, and the light of the cloud's stretches as it comes through that air to the
// camera.

const uint kMostSheets = 4u;    // stretches that the march puts aside
const float kSameColour = 1.0;  // km: so far apart stretches have light of the same colour

// The air before a distance, for a sun of irradiance 1.
struct Before {
  vec3 light;
  vec3 transmittance;
};

const float kRaySlices = 32.0;  // of a ray whose shade is found along it

// What walks through the air along a pixel's ray read.
struct AirRay {
  Ray ray;
  FactorPlace at;
  vec3 direction;
  float reach;
};

ShadedAir further(ShadedAir air, AirRay of, float distance_) {
  float from = shaded_coordinate(of.reach, of.ray.length_, air.distance_);
  float to = shaded_coordinate(of.reach, of.ray.length_, distance_);
  uint steps = uint(clamp(ceil((to - from) * kRaySlices), 0.0, kRaySlices));
  for (uint i = 1u; i <= steps; i++) {
    float z = mix(from, to, float(i) / float(steps));
    air = shaded_up_to(air, of.ray, of.at, of.direction,
                       i < steps ? shaded_distance(of.reach, of.ray.length_, z) : distance_, 2u);
  }
  return air;
}

vec3 share_by_froxels(AirRay of, float distance_) {
  vec3 size = vec3(textureSize(cloud_shafts_lut, 0));
  vec2 at = (vec2(here) + vec2(scene.tile.x, scene.tile.y) + 0.5) / vec2(scene.camera.width, scene.camera.height);
  vec3 place = vec3(at, shaded_coordinate(of.reach, of.ray.length_, distance_));
  return textureLod(cloud_shafts_lut, (vec3(0.5) + place * (size - 1.0)) / size, 0.0).rgb;
}

// The light on the cloud near a distance, for a sun of irradiance 1.
struct CloudColour {
  float t;    // km; below 0: none is known
  vec3 sun;   // unscattered
  vec3 more;  // that lights what is scattered more than once
  vec3 sky;
  vec3 ground;
};

CloudColour colour_at(Ray ray, float t) {
  RayPoint point = sunlit_among_things(scene.planet, ray, t);
  float height = mix(cloud().base, cloud().top, 0.7);
  float h = optical_altitude_at(height);
  MomentCoordinate at = air_moment_coordinate(scene.moments, h, point.mu_sun);
  CloudColour colour;
  colour.t = t;
  colour.sun = transmittance_to_sun(scene.planet, h, point.mu_sun);
  colour.more = colour.sun * sun_past_field(height, h, point.mu_sun);
  colour.sky = level_irradiance(at, 1.0) / kPi;
  colour.ground = level_irradiance(at, -1.0) / kPi * cloud_light.value.below;
  return colour;
}

// The light of a stretch as it leaves the cloud, for a sun of irradiance 1, of which this share is left by things.
vec3 coloured(CloudGathered g, CloudColour colour, float lit) {
  vec3 sunlight = colour.sun * g.once + colour.more * g.sun;
#ifdef AIRLIGHT_THINGS
  sunlight *= lit;
#endif
  return sunlight + colour.sky * g.sky + colour.ground * g.ground;
}

// The change of the ground's light by the cloud, at the ground, for a sun of irradiance 1.
vec3 ground_change(Ray ray, vec3 direction) {
  RayPoint point = sunlit_among_things(scene.planet, ray, ray.length_);
  vec3 place = cloud_place(scene.planet.ground_radius, cloud(), ray.h, direction, ray.length_);
  vec3 direct = transmittance_to_sun(scene.planet, 0.0, point.mu_sun) * ground_facing(scene.planet, point.mu_sun);
  vec3 clear = direct + moment_ground_irradiance(scene.moments, point.mu_sun);
  float lit = exp(-cloud_shade(place, 0.0, point.mu_sun));
  CloudLight light = cloud_light.value;
  vec3 below = max(clear * light.below - direct * light.direct, vec3(0.0)) + direct * lit;
  return (below - clear) * scene.planet.ground_albedo / kPi;
}

struct Walk {
  vec3 light;     // so far, as the camera sees it
  ShadedAir shaded;  // where kAirByRay is 1
  vec3 air;       // of the air up to the last stretch
  vec3 seen;      // of it, what the cloud lets through
  float transmittance;
  CloudColour colour;
};

Walk begun_walk() {
  Walk walk;
  walk.light = vec3(0.0);
  walk.shaded = no_shaded_air();
  walk.air = vec3(0.0);
  walk.seen = vec3(0.0);
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

// Share of the sun that things leave at a point of the ray.
float sun_past_things_at(AirRay of, float t) {
#ifdef AIRLIGHT_THINGS
  Place place = place_at(scene.planet, scene.camera.altitude, of.direction * t);
  return sun_past_things(scene.planet, scene.camera.altitude, scene.sun, place, kNoSphere);
#else
  return 1.0;
#endif
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
    uint changes = walk.colour.t < 0.0 || abs(t - walk.colour.t) > kSameColour ? 1u : 0u;
    for (uint turn = 0u; turn < changes; turn++) {
      walk.colour = colour_at(of.ray, t);
    }
    vec3 light = coloured(g, walk.colour, sun_past_things_at(of, t));
    vec3 air = max(stop.before.light - walk.air, vec3(0.0));
    walk.seen += air * g.before;
    walk.light += air * g.before + stop.before.transmittance * light;
    walk.air = max(stop.before.light, walk.air);
  }
  return walk;
}
