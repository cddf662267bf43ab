// Light of the air that is not sunlight scattered once, up to things, by an aerial volume, and what terrain leaves of
// it.
#include "shared/thing_shares.glsl"

// As if there were no terrain.
vec3 diffuse_up_to(VolumeRay of, float distance_) {
  VolumePlace place = volume_place(of, distance_);
  return fetch_block(diffuse_block(), of.at, place.w) * gathered_share(depth_up_to(place));
}

// Distance from the camera beyond which terrain takes and adds nothing more, km.
float dimmed_reach() {
  TerrainData terrain = terrain_shape();
  float centre = length(vec2(terrain.centre_east, terrain.centre_north));
  return centre + terrain.texel * float(max(terrain.columns, terrain.rows));
}

// Share of a step's light.
vec3 dimmed_in_step(Sight sight, float from, float to) {
  float middle = 0.5 * (from + to);
  float s = ground_distance(scene.planet, sight.ray.h, sight.ray.mu, middle);
  return air_share(terrain_shape(), kShareAlong, track_east(sight.track, s), track_north(sight.track, s),
                   point_on_ray(scene.planet, sight.ray, middle).h);
}

// Where the steps end on the way among terrain, from 0 to 1 over dimmed_reach(): they grow with the distance.
float dimmed_distance(float z) { return z * z; }
float dimmed_coordinate(float share) { return sqrt(min(share, 1.0)); }
