// The terrain's maps as buffers.
#include "shared/terrain.h"

layout(scalar, set = 0, binding = 10) readonly buffer Terrain {
  TerrainData shape;
  float heights[];
} terrain;

// Copied out of the buffer once, like the media.
TerrainData loaded_terrain = terrain.shape;
TerrainData terrain_shape() { return loaded_terrain; }
uint terrain_level(uint level) { return terrain.shape.level_first[level]; }
float terrain_height(uint k) { return terrain.heights[k]; }
