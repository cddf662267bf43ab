// The terrain's maps as buffers: heights, shadow, albedo.

layout(scalar, set = 0, binding = 10) readonly buffer Terrain {
  TerrainData shape;
  float heights[];
} terrain;
layout(scalar, set = 0, binding = 11) readonly buffer TerrainShadow { uint values[]; } terrain_shadows;
layout(scalar, set = 0, binding = 12) readonly buffer TerrainColour { uint values[]; } terrain_colours;

// Copied out of the buffer once, like the media.
TerrainData loaded_terrain = terrain.shape;
TerrainData terrain_shape() { return loaded_terrain; }
uint terrain_level(uint level) { return terrain.shape.level_first[level]; }
float terrain_height(uint k) { return terrain.heights[k]; }

uint terrain_shadow(uint k) { return terrain_shadows.values[k]; }

// The square roots of three channels, 10 bits each.
vec3 terrain_colour(uint k) {
  uint bits = terrain_colours.values[k];
  vec3 root = vec3(bits & 1023u, (bits >> 10u) & 1023u, bits >> 20u) / 1023.0;
  return root * root;
}

#include "physics/terrain.glsl"
