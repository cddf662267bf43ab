// A cloud's water where its edge is carved finer than its grid (physics/cloud_edge.glsl).
#include "physics/cloud_edge.glsl"
layout(set = 0, binding = 33) uniform sampler3D cloud_noise_lut;  // that carves the edge; any image where kCarved is 0
layout(constant_id = 51) const uint kCarved = 0u;  // 1: the cloud's edge is finer than its grid

const float kMeanNoise = 0.547;  // carving_noise()
const uint kNoiseSide = 64u;     // texels

float noise_at(vec3 place) {
  vec3 texel = vec3(cell_texel(place.x, kNoiseSide), cell_texel(place.y, kNoiseSide), cell_texel(place.z, kNoiseSide));
  return textureLod(cloud_noise_lut, texel / float(kNoiseSide + 1u), 0.0).r;
}

// Extinction, 1/km, at a place so far inside the cloud, km. `finer`: the share of the finer tiles' noise, 0 to 1; their
// mean takes the place of the rest.
float carved_extinction(vec3 place, float inside, float finer) {
  CloudEdge edge = cloud().edge;
  vec3 tile = place * vec3(edge.tiles, edge.tiles, edge.tile_levels);
  float carved = 0.0;
  if (inside > 0.0 && inside < edge.carving + edge.soft) {
    carved = edge_carved(place.z, noise_at(tile), mix(kMeanNoise, noise_at(tile * kCloudFiner), finer));
  }
  return inside > 0.0 ? edge_extinction(edge, place.z, inside, carved) : 0.0;
}
