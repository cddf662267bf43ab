#version 460
#extension GL_GOOGLE_include_directive : require
// What a cloud's coarse cells send, as an image of blocks side by side (shared/cloud_blocks.glsl): the sun's light by
// harmonic, that of sky and ground in harmonics 0, 2 and 6, found on coarser cells. The picture looks up between cells,
// and asks where there is water alone: a cell with little water takes the light of the water around it, so that the
// clear air beside a cloud does not count as its surface. Light falls toward sides and a base that the sun does not
// reach, and grazing rays see no more than its last free path: what a cell takes from its neighbour on a level lies on
// the line through that one and the next one inward, and so do a slice below the base and one above the top.
#include "shared/cloud_cells.glsl"
#include "shared/cloud_blocks.glsl"
#include "shared/cloud_coarser.glsl"

layout(local_size_x = 64) in;
layout(scalar, set = 0, binding = 2) readonly buffer Scattering { CloudScattering value; } scattering;
layout(scalar, set = 0, binding = 3) readonly buffer Sun { float values[]; } sun;
layout(scalar, set = 0, binding = 4) readonly buffer Sky { float values[]; } sky;
layout(scalar, set = 0, binding = 5) readonly buffer Ground { float values[]; } ground;
layout(set = 0, binding = 6, rgba32f) uniform writeonly image3D source_out;
layout(scalar, set = 0, binding = 7) readonly buffer Cells { float values[]; } cells;  // extinction
layout(scalar, set = 0, binding = 8) readonly buffer CoarserCells { float values[]; } coarser_cells;
layout(push_constant, scalar) uniform Push {
  uvec3 size;
  uvec3 coarser;  // cells of sky and ground
};

const float kAround = 0.5;       // what the water around a cell counts beside its own
const float kLeastAtFace = 0.1;  // of a cell's light, the least that is left at the cloud's face

uint index_of(uvec3 cell, uvec3 counts) { return (cell.z * counts.y + cell.y) * counts.x + cell.x; }

// Four harmonics of the sun's light in a cell.
vec4 sunlit(uint first, uvec3 cell) {
  uint count = size.x * size.y * size.z;
  uint at = index_of(cell, size);
  vec4 light;
  UNROLL for (uint q = 0u; q < 4u; q++) {
    light[q] = first + q < kCloudMoments ? sun.values[(first + q) * count + at] : 0.0;
  }
  return light;
}

// By how much of the difference between a cell and the next one inward a line beyond it goes on.
float goes_on(float here, float inner) {
  return inner > here ? min(1.0, 2.0 * (1.0 - kLeastAtFace) * max(here, 0.0) / (inner - here)) : 1.0;
}

// The same a cell beyond `cell`, away from the cell `inner`: on the line through the two where both hold water.
vec4 sunlit_beyond(uint first, uvec3 cell, uvec3 inner) {
  vec4 light = sunlit(first, cell);
  if (cells.values[index_of(inner, size)] > 0.0) {
    light += (light - sunlit(first, inner)) * goes_on(sunlit(0u, cell).x, sunlit(0u, inner).x);
  }
  return light;
}

// The same among the water around, of its own level where there is some: light changes most upward.
vec4 sunlit_water(uint first, uvec3 cell) {
  vec4 level = vec4(0.0);
  vec4 other = vec4(0.0);
  float level_water = 0.0;
  float other_water = 0.0;
  for (uint n = 0u; n < 27u; n++) {
    uvec3 off = uvec3(n % 3u, n / 3u % 3u, n / 9u);  // one too far on each axis
    uvec3 near = cell + off;
    if (near.z == 0u || near.z > size.z) {
      continue;
    }
    near = uvec3((near.xy + size.xy - 1u) % size.xy, near.z - 1u);
    float there = cells.values[index_of(near, size)];
    if (there > 0.0 && near.z == cell.z) {
      uvec3 inner = uvec3((near.xy + off.xy + size.xy - 1u) % size.xy, near.z);
      level += there * (inner == near ? sunlit(first, near) : sunlit_beyond(first, near, inner));
      level_water += there;
    } else if (there > 0.0 && level_water == 0.0) {
      other += there * sunlit(first, near);
      other_water += there;
    }
  }
  vec4 here = sunlit(first, cell);
  float own = cells.values[index_of(cell, size)];
  if (level_water > 0.0) {
    return mix(level / level_water, here, own / (own + kAround * level_water / 9.0));
  }
  return other_water > 0.0 ? other / other_water : here;
}

// Harmonics 0, 2 and 6 of the light of sky or ground, between the coarser cells by the water that they hold.
vec3 even_light(bool of_sky, uvec3 cell) {
  EightCells around = coarser_cells_around(cell, size, coarser);
  uint count = coarser.x * coarser.y * coarser.z;
  vec3 sum = vec3(0.0);
  float water = 0.0;
  for (uint n = 0u; n < 8u; n++) {
    uint at = coarser_cell(around, coarser, n);
    float weight = coarser_share(around, n) * max(coarser_cells.values[at], kDrySpace);
    sum += weight * (of_sky ? vec3(sky.values[at], sky.values[2u * count + at], sky.values[6u * count + at])
                            : vec3(ground.values[at], ground.values[2u * count + at], ground.values[6u * count + at]));
    water += weight;
  }
  return sum / water;
}

float kept(uint i) {
  if (i < kCloudSky) {
    return scattering.value.kept[i];
  }
  uint rest = (i - kCloudSky) % 3u;
  return scattering.value.kept[rest == 0u ? 0u : (rest == 1u ? 2u : 6u)];
}

// The four values of a block in a cell.
vec4 light_of(uint block, uvec3 cell) {
  uint first = 4u * block;
  vec4 light = first < kCloudSky ? sunlit_water(first, cell) : vec4(0.0);
  if (first + 3u >= kCloudSky) {
    vec3 of_sky = even_light(true, cell);
    vec3 of_ground = even_light(false, cell);
    UNROLL for (uint q = 0u; q < 4u; q++) {
      uint i = first + q;
      if (i >= kCloudSky && i < kCloudGround) {
        light[q] = of_sky[i - kCloudSky];
      } else if (i >= kCloudGround) {
        light[q] = i < kCloudGround + 3u ? of_ground[i - kCloudGround] : 0.0;
      }
    }
  }
  UNROLL for (uint q = 0u; q < 4u; q++) {
    light[q] *= first + q < kCloudGround + 3u ? kept(first + q) : 0.0;
  }
  return light;
}

void main() {
  uvec3 at = gl_GlobalInvocationID;
  uint columns = size.x + 1u;
  if (at.x >= columns * kCloudBlocks || at.y > size.y || at.z >= size.z + 2u) {
    return;
  }
  uint block = at.x / columns;
  uvec3 cell = uvec3((at.x % columns + size.x - 1u) % size.x, (at.y + size.y - 1u) % size.y,
                     clamp(at.z, 1u, size.z) - 1u);
  vec4 light = light_of(block, cell);
  if (cell.z + 1u != at.z && size.z > 1u) {
    uvec3 inner = uvec3(cell.xy, cell.z == 0u ? 1u : size.z - 2u);
    if (cells.values[index_of(cell, size)] > 0.0 && cells.values[index_of(inner, size)] > 0.0) {
      float of_sun = goes_on(sunlit_water(0u, cell).x, sunlit_water(0u, inner).x);
      float of_sky = goes_on(even_light(true, cell).x, even_light(true, inner).x);
      float of_ground = goes_on(even_light(false, cell).x, even_light(false, inner).x);
      vec4 change = light - light_of(block, inner);
      UNROLL for (uint q = 0u; q < 4u; q++) {
        uint i = 4u * block + q;
        light[q] += change[q] * (i < kCloudSky ? of_sun : (i < kCloudGround ? of_sky : of_ground));
      }
    }
  }
  imageStore(source_out, ivec3(at), light);
}
