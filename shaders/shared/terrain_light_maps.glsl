// Further inputs of the terrain's light: its shadow, its albedo.
layout(scalar, set = 0, binding = 11) readonly buffer TerrainShadow { vec2 values[]; } terrain_shadows;
layout(scalar, set = 0, binding = 12) readonly buffer TerrainColour { uint values[]; } terrain_colours;

vec2 terrain_shadow(uint k) { return terrain_shadows.values[k]; }

// The square roots of three channels, 10 bits each.
vec3 terrain_colour(uint k) {
  uint bits = terrain_colours.values[k];
  vec3 root = vec3(bits & 1023u, (bits >> 10u) & 1023u, bits >> 20u) / 1023.0;
  return root * root;
}
