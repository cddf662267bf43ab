// The air's light among clouds: its sunlight scattered once, and light from about the sun, where the cloud's shadow
// leaves the sun; the rest by the light below and above the cloud.
#include "shared/cloud_balance.glsl"
#include "shared/cloud_stack.glsl"

// Distances along a ray count from where it enters the air, as its part in the air does: so far from the camera, km.
float way_to_air(vec3 direction) {
  return table_from_space() ? air_entry(scene.planet, scene.camera.altitude, direction.y).distance_ : 0.0;
}

// Light of the air without clouds up to a distance, for a sun of irradiance 1.
struct ClearAir {
  vec3 once;
  vec3 more;  // scattered more than once
  vec3 open;  // the same where no things stand
  vec3 depth;
};

ClearAir clear_air_up_to(Ray ray, FactorPlace at, float distance_) {
  float reach = clamp(distance_, 0.0, max(ray.length_, 0.0));
  float z = slice_coordinate(scene.planet, ray, reach);
  ClearAir air;
  air.depth = textureLod(extinction_lut, vec2(texel_from_unit(z, float(kExtinctionSlices)), at.v), 0.0).rgb * reach;
  float w = texel_from_unit(z, float(kSlices));
  vec3 gathered = air.depth * segment_transfer(air.depth).mean;
  air.more = fetch_block(diffuse_block(), at, w) * volume_carrier(at.nu) * gathered;
  air.open = air.more;
  air.once = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    air.once += scatters(i) ? fetch_block(single_block(i), at, w) * (medium_phase(i, at.nu) * gathered) : vec3(0.0);
  }
#ifdef AIRLIGHT_THINGS
  VolumeRay of;
  of.at = at;
  of.ray = ray;
  air.once = past_shadows(of, reach, air.once);
  air.more = dimmed_to(of, seen_sight, reach, air.more);
#endif
  return air;
}

// Optical length of a ray up to a distance. A ray's own length is optical: there the ray ends. From space a place is
// known by its altitude: of a ray near the planet's edge, its true length would differ by more than the clouds' height.
float optical_up_to(Ray ray, float distance_) {
  float t = distance_;
  if (!table_from_space()) {
    t = optical_length(scene.planet, ray.h, ray.mu, distance_);
  } else if (bends_light()) {
    float g = optical_altitude_at(point_on_ray(scene.planet, ray, distance_).h);
    CloudCrossing level = sphere_crossing(scene.planet.ground_radius, ray.h, ray.mu, g);
    float lowest = lowest_distance(scene.planet, ray);
    t = level.from > level.to ? lowest : distance_ < lowest ? level.from : level.to;
  }
  return distance_ < ray.length_ ? t : ray.length_;
}

// Light of the air up to a distance.
struct ShadedAir {
  float distance_;
  ClearAir clear;
  vec3 left;  // of it, among clouds
};

ShadedAir no_shaded_air() {
  ShadedAir air;
  air.distance_ = 0.0;
  air.clear.once = vec3(0.0);
  air.clear.more = vec3(0.0);
  air.clear.open = vec3(0.0);
  air.clear.depth = vec3(0.0);
  air.left = vec3(0.0);
  return air;
}

// Light that the air of a stretch scatters more than once, as a clear sky does.
struct MoreAir {
  vec3 near_sun;  // of light from about the sun
  vec3 others;    // of all other light
  vec3 even;      // what the others would be, were they as bright in all directions, over them
};

// Light from about the sun is scattered as the sun's is. It is not as sharp, so the others are no less than were they
// even, where haze turns the light toward the camera.
MoreAir more_air(Ray ray, ShadedAir air, ClearAir next, float to) {
  const float kMost = 4.0;
  RayPoint point = sunlit_among_things(scene.planet, ray, 0.5 * (air.distance_ + to));
  MomentCoordinate at = air_moment_coordinate(scene.moments, point.h, point.mu_sun);
  vec3 near_sun = light_around_sun(at, point.h, point.mu_sun);
  vec3 past = exp(-air.clear.depth) * segment_transfer(max(next.depth - air.clear.depth, vec3(0.0))).mean;
  vec3 even = air_at(point.h, equal_phases(0.0)).scattering * past * (to - air.distance_);
  even *= (light_from_all_around(at) - near_sun) / (4.0 * kPi);
  vec3 over_sun = near_sun / max(transmittance_to_sun(scene.planet, point.h, point.mu_sun), vec3(1e-20));
  vec3 more = max(next.more - air.clear.more, vec3(0.0));
  MoreAir of;
  of.near_sun = min(max(next.once - air.clear.once, vec3(0.0)) * over_sun, max(more - even, vec3(0.0)));
  of.others = more - of.near_sun;
  of.even = min(even / max(next.open - air.clear.open - of.near_sun, vec3(1e-20)), vec3(kMost));
  return of;
}

// Goes on to a distance; the sun is asked for in the middles of so many parts, all other light in the middle of all.
// `before`: way_to_air().
ShadedAir shaded_up_to(ShadedAir air, Ray ray, FactorPlace at, vec3 direction, float before, float to, uint parts) {
  float width = (to - air.distance_) / float(parts);
  float lit = 0.0;
  float sunny = 0.0;  // parts that the planet does not hide from the sun: light scattered once comes from these alone
  vec3 others = vec3(1.0);
  for (uint i = 0u; i < parts; i++) {
    float t = air.distance_ + (float(i) + 0.5) * width;
    RayPoint point = sunlit_among_things(scene.planet, ray, t);
    vec3 place = seen_in(cloud(), direction, before + t);
    float counts = meets_ground(scene.planet, point.h, seen_sun_mu(scene.planet, point.h, point.mu_sun)) ? 0.0 : 1.0;
    float shade = cloud_shade(place, point.h, point.mu_sun);
    if (kFields > 1u) {
      OtherFields past = past_other_fields(direction, before + t, point.h, point.mu_sun);
      shade += past.shade;
      others += (past.air - 1.0) / float(parts);
    }
    lit += counts * exp(-shade);
    sunny += counts;
  }
  vec3 middle = seen_in(cloud(), direction, before + 0.5 * (air.distance_ + to));
  MoreLight more = more_light_at(middle);
  lit /= max(sunny, 1.0);
  ClearAir next = clear_air_up_to(ray, at, optical_up_to(ray, to));
  MoreAir of = more_air(ray, air, next, to);
  vec3 share = (more.share + more.even * (of.even - 1.0)) * others;
  air.left += (max(next.once - air.clear.once, vec3(0.0)) + of.near_sun) * lit + of.others * share;
  air.clear = next;
  air.distance_ = to;
  return air;
}

// 1 where there is no air yet.
vec3 share_left(ShadedAir air) {
  const vec3 kNone = vec3(1e-20);
  return (air.left + kNone) / (air.clear.once + air.clear.more + kNone);
}
