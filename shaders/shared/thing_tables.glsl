// The air among things by tables: no ray marches. Light and transmittance up to any distance are the aerial volume's, and
// what shadows leave of the light scattered once is found apart.
#include "shared/thing_volume.glsl"
#include "shared/thing_dimmed.glsl"

layout(set = 0, binding = 5) uniform sampler2D peaks_lut;   // mean extinction by forward peaks, as extinction_lut
layout(set = 0, binding = 6) uniform sampler3D shafts_lut;  // thing_shafts.comp; any image where kShafts needs none
layout(set = 0, binding = 21) uniform sampler3D dimmed_lut;  // thing_dimmed.comp; any image where kDimmed needs none
const uint kDimmedStepCount = 10u;
layout(constant_id = 60) const uint kDimmed = kDimmedNone;
layout(constant_id = 35) const uint kShafts = kShaftsNone;

// The same by froxels.
vec3 single_past_froxels(VolumeRay of, Phases p, Sight sight, float distance_, vec3 all) {
  float shaded = shaded_length(sight);
  if (shaded <= 0.0) {
    return all;
  }
  vec3 size = vec3(textureSize(shafts_lut, 0));
  vec2 at = pixel_centre(here) / vec2(scene.camera.width, scene.camera.height);
  vec3 place = vec3(at, shaft_coordinate(distance_ / shaded));
  vec3 share = textureLod(shafts_lut, (vec3(0.5) + place * (size - 1.0)) / size, 0.0).rgb;
  if (distance_ <= shaded) {
    return all * share;
  }
  return all - (vec3(1.0) - share) * single_up_to(of, p, shaded);
}

vec3 single_to(VolumeRay of, Phases p, Sight sight, float distance_, vec3 all) {
  if (!has_terrain() || distance_ <= 0.0) {
    return all;
  }
  bool mirrored = dot(sight.from.point, sight.from.point) > 0.0;
  if (kShafts == kShaftsExact || mirrored) {
    return single_past_terrain(of, p, sight, distance_, all);
  }
  return single_past_froxels(of, p, sight, distance_, all);
}

// Mean share of the sun past terrain from one distance to another.
float share_past_terrain(Sight sight, float from, float to) {
  if (!has_terrain()) {
    return 1.0;
  }
  ShadowWalk walk = shadow_walk(scene.planet, sight.track, sight.ray, to);
  return mean_sunlit(over_shadow(walk, from / max(to, 1e-9)), over_shadow(walk, 1.0), 0.5 * (to - from));
}

// What is scattered once on the way in the sun, where `all` would be without things: the ray less its parts in the
// shadows of bodies, gone through in order.
vec3 lit_single(VolumeRay of, Phases p, Sight sight, float distance_, vec3 all) {
  vec3 sum = single_to(of, p, sight, distance_, all);
  float at = 0.0;
  for (uint turn = 0u; turn < bodies_before(); turn++) {
    float from = distance_;
    float to = distance_;
    for (uint i = 0u; i < bodies_before(); i++) {
      ShadowSpan span = shadow_of_body(i, sight.from.point, sight.direction, scene.sun.seen);
      bool next = span.to > at && span.from < from;
      from = next ? max(span.from, at) : from;
      to = next ? span.to : to;
    }
    if (from >= distance_) {
      break;
    }
    at = min(to, distance_);
    vec3 hidden = single_up_to(of, p, at) - single_up_to(of, p, from);
    sum -= max(hidden, vec3(0.0)) * share_past_terrain(sight, from, at);
  }
  return sum;
}

// The air's other light up to a distance, which without terrain is `all`.
vec3 dimmed_to(VolumeRay of, Sight sight, float distance_, vec3 all) {
  if (kDimmed == kDimmedNone || distance_ <= 0.0) {
    return all;
  }
  float reach = dimmed_reach();
  bool mirrored = dot(sight.from.point, sight.from.point) > 0.0;
  if (kDimmed == kDimmedFroxels && !mirrored) {
    vec3 size = vec3(textureSize(dimmed_lut, 0));
    vec2 at = pixel_centre(here) / vec2(scene.camera.width, scene.camera.height);
    vec3 place = vec3(at, dimmed_coordinate(distance_ / reach));
    vec3 share = textureLod(dimmed_lut, (vec3(0.5) + place * (size - 1.0)) / size, 0.0).rgb;
    return distance_ <= reach ? all * share : all - (vec3(1.0) - share) * diffuse_up_to(of, reach);
  }
  vec3 sum = vec3(0.0);
  vec3 before = vec3(0.0);
  float end = min(distance_, reach);
  float from = 0.0;
  for (uint i = 1u; i <= kDimmedStepCount; i++) {
    float to = end * dimmed_distance(float(i) / float(kDimmedStepCount));
    vec3 next = diffuse_up_to(of, to);
    sum += max(next - before, vec3(0.0)) * dimmed_in_step(sight, from, to);
    before = next;
    from = to;
  }
  return sum + max(all - before, vec3(0.0));
}

// Factors of the air along `ray`, which is the sight's or ends before it.
SkyFactors factors_past_things(Sight sight, Ray ray, uint steps) {
  VolumeRay of = volume_ray(sight);
  VolumePlace place = volume_place(of, ray.length_);
  SkyFactors air = no_air();
  air.depth = depth_up_to(place);
  SegmentTransfer segment = segment_transfer(air.depth);
  air.transmittance = segment.through;
  air.peaks = textureLod(peaks_lut, place.row, 0.0).rgb * place.distance_;
  vec3 gathered = air.depth * segment.mean;
  air.diffuse = dimmed_to(of, sight, ray.length_, fetch_block(diffuse_block(), of.at, place.w) * gathered);
  Phases p = phases(seen_cosine(scene.sun, ray.mu, ray.nu));
  vec3 all = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    if (scatters(i)) {
      air.single[i] = fetch_block(single_block(i), of.at, place.w) * gathered;
      all += air.single[i] * p.of[i];
    }
  }
  if (kShafts != kShaftsNone) {
    vec3 share = max(lit_single(of, p, sight, ray.length_, all), vec3(0.0)) / max(all, vec3(1e-30));
    UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
      air.single[i] *= share;
    }
  }
  return air;
}
