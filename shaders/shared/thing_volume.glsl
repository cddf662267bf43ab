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

// Light scattered once up to a distance, in the shadow of terrain; without things it is `all`. The sum over steps of
// their share of the sun V times what is scattered in them is taken by parts: sum of G(t) (V_k - V_k+1), where G is the
// light scattered up to t. Along the ray G is taken as the polynomial in the root of the distance through its values at
// the quarters of the root, so the steps gather four sums of powers alone, and the volume is asked for these values
// where any share changes.
vec3 single_past_terrain(VolumeRay of, Phases p, Sight sight, float distance_, vec3 all) {
  float shaded = min(distance_, shaded_length(sight));
  float width = shaded / float(kShaftSteps);
  ShadowWalk walk = shadow_walk(scene.planet, sight.track, sight.ray, shaded);
  vec2 near = over_shadow(walk, 0.0);
  float before = 1.0;
  vec4 powers = vec4(0.0);
  for (uint i = 1u; i <= kShaftSteps; i++) {
    vec2 far = over_shadow(walk, float(i) / float(kShaftSteps));
    float share = mean_sunlit(near, far, 0.5 * width);
    float z = sqrt(float(i - 1u) / float(kShaftSteps));
    powers += (before - share) * z * vec4(1.0, z, z * z, z * z * z);
    before = share;
    near = far;
  }
  powers += vec4(before - 1.0);
  bool changed = dot(abs(powers), vec4(1.0)) > 1e-4;
  // Of the value at each quarter, by Lagrange's polynomials.
  vec4 weights = vec4(16.0 * powers.x - 208.0 / 3.0 * powers.y + 96.0 * powers.z - 128.0 / 3.0 * powers.w,
                      -12.0 * powers.x + 76.0 * powers.y - 128.0 * powers.z + 64.0 * powers.w,
                      16.0 / 3.0 * powers.x - 112.0 / 3.0 * powers.y + 224.0 / 3.0 * powers.z - 128.0 / 3.0 * powers.w,
                      -powers.x + 22.0 / 3.0 * powers.y - 16.0 * powers.z + 32.0 / 3.0 * powers.w);
  vec3 sum = all;
  uint nodes = changed ? 4u : 0u;
  for (uint i = 0u; i < nodes; i++) {
    float z = 0.25 * float(i + 1u);
    sum += single_up_to(of, p, z * z * shaded) * weights[i];
  }
  return sum;
}
