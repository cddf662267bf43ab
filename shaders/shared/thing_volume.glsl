// Light scattered once up to things, by an aerial volume that keeps all media apart, and what shadows of terrain leave of
// it. A mirror's ray takes the volume as if it began at the camera.
#include "shared/things.glsl"
#include "shared/volume_fetch.glsl"

// A ray of the volume.
struct VolumeRay {
  FactorPlace at;
  Ray ray;
};

// A mirror's ray that does not end on the ground is one of the camera's that does not either.
VolumeRay volume_ray(Sight sight) {
  vec3 direction = sight.direction;
  float horizon = horizon_mu(scene.planet, scene.camera.altitude);
  direction.y = sight.ray.at_ground ? direction.y : max(direction.y, horizon);
  VolumeRay of;
  of.at = factor_place(direction);
  of.ray = air_ray(direction);
  return of;
}

// A distance along the volume's ray: where its slices and mean extinctions stand.
struct VolumePlace {
  float w;
  vec2 row;
  float distance_;
};

VolumePlace volume_place(VolumeRay of, float distance_) {
  VolumePlace place;
  place.distance_ = clamp(distance_, 0.0, max(of.ray.length_, 0.0));
  float z = slice_coordinate(scene.planet, of.ray, place.distance_);
  place.w = texel_from_unit(z, float(kSlices));
  place.row = vec2(texel_from_unit(z, float(kExtinctionSlices)), of.at.v);
  return place;
}

vec3 depth_up_to(VolumePlace place) { return textureLod(extinction_lut, place.row, 0.0).rgb * place.distance_; }

// Light scattered once on the way, as if there were no things.
vec3 single_up_to(VolumeRay of, Phases p, float distance_) {
  VolumePlace place = volume_place(of, distance_);
  vec3 source = vec3(0.0);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    source += scatters(i) ? fetch_block(single_block(i), of.at, place.w) * p.of[i] : vec3(0.0);
  }
  return source * gathered_share(depth_up_to(place));
}

// Length of a ray's way below the shadows of terrain, from its start: beyond it or above them all air is in the sun.
// Shadows of a sun on the horizon rise by little over the terrain's highest place.
float shaded_length(Sight sight) {
  TerrainData terrain = terrain_shape();
  float reach = terrain.shadow_reach + length(vec2(sight.track.from_east, sight.track.from_north));
  float level = track_distance(scene.planet, sight.track, reach);
  PlanetData below = scene.planet;
  below.atmosphere_height = terrain_height(terrain_level(terrain.levels - 1u)) + 0.01 * terrain.shadow_reach;
  return min(level, distance_to_top(below, sight.from.h, sight.track.mu));
}

// Where froxels end on the way below shadows, from 0 to 1, and its inverse: they grow with the distance.
float shaft_distance(float z) { return z * z; }
float shaft_coordinate(float share) { return sqrt(min(share, 1.0)); }

const uint kShaftSteps = 24u;

// Light scattered once up to a distance, in the shadow of terrain; without things it is `all`. The sum over steps of their
// share of the sun times what is scattered in them is taken by parts, so that the volume is asked only where the share
// changes.
vec3 single_past_terrain(VolumeRay of, Phases p, Sight sight, float distance_, vec3 all) {
  float shaded = min(distance_, shaded_length(sight));
  float width = shaded / float(kShaftSteps);
  vec2 near = over_shadow(scene.planet, sight.track, sight.ray, 0.0);
  float share = 1.0;
  vec3 sum = all;
  uint i = 1u;
  while (i <= kShaftSteps + 1u) {
    // Steps are walked in a loop of their own: a software device asks the volume in each turn of the outer one, asked or
    // not.
    float before = share;
    bool changed = false;
    for (; !changed && i <= kShaftSteps + 1u; i++) {
      vec2 far = over_shadow(scene.planet, sight.track, sight.ray, float(i) * width);
      float next = i <= kShaftSteps ? mean_sunlit(near, far, 0.5 * width) : 1.0;
      changed = i > 1u && abs(next - share) > 1e-3;
      before = share;
      share = next;
      near = far;
    }
    vec3 up_to = single_up_to(of, p, float(i - 2u) * width);
    sum += changed ? up_to * (before - share) : vec3(0.0);
  }
  return sum;
}
