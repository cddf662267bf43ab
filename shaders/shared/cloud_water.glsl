// A cloud's water along a pixel's ray, and what it leaves of the sun there: the edge of a field is carved finer than
// its grid (physics/cloud_edge.glsl).
#include "physics/cloud_edge.glsl"
layout(set = 0, binding = 33) uniform sampler3D cloud_noise_lut;  // that carves the edge; any image where kCarved is 0
layout(constant_id = 51) const uint kCarved = 0u;  // 1: the cloud's edge is finer than its grid

const float kEdgeStep = 0.3;    // of `step`, the most of a step in a carved edge
const float kEdgeRise = 0.006;  // of that over the distance
// km: from the first to the second the edge passes into means, its finer lobes into theirs.
const vec2 kCarvedRange = vec2(25.0, 50.0);
const vec2 kFinerRange = vec2(6.0, 12.0);
const float kMeanNoise = 0.547;  // carving_noise()
const uint kNoiseSide = 64u;  // texels

// Water at a place of a ray: extinction, 1/km, and how far inside the cloud the place is, km.
struct Water {
  float extinction;
  float inside;
};

float noise_at(vec3 place) {
  vec3 texel = vec3(cell_texel(place.x, kNoiseSide), cell_texel(place.y, kNoiseSide), cell_texel(place.z, kNoiseSide));
  return textureLod(cloud_noise_lut, texel / float(kNoiseSide + 1u), 0.0).r;
}

Water water_on_ray(vec3 place, float t) {
  CloudEdge edge = cloud().edge;
  Water water;
  water.extinction = 0.0;
  water.inside = 0.0;
  if (!inside_cloud_grid(cloud(), place)) {
    return water;
  }
  vec2 mean = water_at(place);
  water.extinction = mean.x;
  water.inside = mean.y;
  // As a loop: a processor runs the code of a branch that none takes, but no turn of a loop.
  uint turns = kCarved == 1u && t < kCarvedRange.y ? 1u : 0u;
  for (uint turn = 0u; turn < turns; turn++) {
    vec3 tile = place * vec3(edge.tiles, edge.tiles, edge.tile_levels);
    float near = 1.0 - smoothstep(kFinerRange.x, kFinerRange.y, t);
    float carved = 0.0;
    uint edges = mean.y > 0.0 && mean.y < edge.carving + edge.soft ? 1u : 0u;
    for (uint one = 0u; one < edges; one++) {
      float finer = mix(kMeanNoise, noise_at(tile * kCloudFiner), near);
      carved = edge_carved(place.z, noise_at(tile), finer);
    }
    float fine = mean.y > 0.0 ? edge_extinction(edge, place.z, mean.y, carved) : 0.0;
    water.extinction = mix(fine, mean.x, smoothstep(kCarvedRange.x, kCarvedRange.y, t));
  }
  return water;
}

// The longest step from a place that misses no lobe of a carved edge.
float step_in_water(float inside, float t) {
  CloudEdge edge = cloud().edge;
  float away = max(-inside, inside - edge.carving - edge.soft);
  return kCarved == 1u && t < kCarvedRange.y ? max(max(step * kEdgeStep, t * kEdgeRise), away) : 1e9;
}

float shade_on_ray(Ray ray, vec3 place, float t) {
  RayPoint point = sunlit_among_things(scene.planet, ray, t);
  return cloud_shade(place, point.h, point.mu_sun);
}
