// A cloud's grid as passes read it. Places are 0 to 1 over the grid's width, depth and height.
#include "shared/cloud.h"
layout(scalar, set = 0, binding = 29) readonly buffer Cloud { CloudData value; } cloud_data;
layout(set = 0, binding = 30) uniform sampler3D cloud_density_lut;

CloudData loaded_cloud = cloud_data.value;
CloudData cloud() { return loaded_cloud; }

// The texel of a place among cells whose first texel is the last cell's, once more.
float cell_texel(float place, uint cells) {
  float at = (place - floor(place)) * float(cells) + 0.5;
  return (at < float(cells) ? at : at - float(cells)) + 0.5;
}

// The mean extinction around a place, 1/km, and how far inside the cloud it lies, km (physics/cloud_edge.glsl).
vec2 water_at(vec3 place) {
  CloudData c = cloud();
  vec2 texel = vec2(cell_texel(place.x, c.fine_x), cell_texel(place.y, c.fine_y));
  return textureLod(cloud_density_lut, vec3(texel / vec2(c.fine_x + 1u, c.fine_y + 1u), place.z), 0.0).rg;
}

float density_at(vec3 place) { return water_at(place).r; }
