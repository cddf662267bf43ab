// The ground's maps as buffers.

layout(scalar, set = 0, binding = 14) readonly buffer GroundHead { GroundData head; } ground_head;
layout(scalar, set = 0, binding = 16) readonly buffer GroundAlbedo { uint values[]; } ground_albedo;
layout(scalar, set = 0, binding = 17) readonly buffer GroundWater { uint values[]; } ground_water;

// Copied out of the buffer once, like the media.
GroundShape loaded_ground = ground_head.head.shape;
GroundShape ground_shape() { return loaded_ground; }
uint ground_albedo_first(uint level) { return ground_head.head.albedo_first[level]; }
uint ground_water_first(uint level) { return ground_head.head.water_first[level]; }
float ground_glint_share(uint i) { return ground_head.head.glint_share[i]; }

// The square roots of three channels, 10 bits each.
vec3 ground_albedo_texel(uint k) {
  uint bits = ground_albedo.values[k];
  vec3 root = vec3(bits & 1023u, (bits >> 10u) & 1023u, bits >> 20u) / 1023.0;
  return root * root;
}

// Four texels in each word.
float ground_water_texel(uint k) {
  return float((ground_water.values[k >> 2u] >> (8u * (k & 3u))) & 255u) / 255.0;
}

#include "physics/ocean_glint.glsl"
#include "physics/ground_map.glsl"
