#version 460
#extension GL_GOOGLE_include_directive : require
// Mean optical depth of a field that repeats itself, per km of a way through its shell, by slope: that of the mean of
// what is left of light along rays in the sun's azimuth. One workgroup a slope.
#extension GL_EXT_scalar_block_layout : require
#define real float
#include "shared/cloud_volume.glsl"
#include "physics/segment.glsl"
#include "physics/cloud_march.glsl"
#include "physics/cloud_sun.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D mean_out;

const uint kRays = 4u;  // a thread
const uint kMostParts = 512u;

shared float left[64];

void main() {
  CloudData c = cloud();
  uint row = gl_WorkGroupID.x;
  uint thread = gl_LocalInvocationIndex;
  float slope = cloud_mean_slope(float(row));
  float height = c.top - c.base;
  float across = sqrt(1.0 - slope * slope) / slope * height;
  vec2 azimuth = vec2(c.sunward_east, c.sunward_north);
  azimuth = azimuth / max(length(azimuth), 1e-9);
  vec2 cell = vec2(c.width / float(c.fine_x), c.depth / float(c.fine_y));
  uint parts = uint(clamp(across / min(cell.x, cell.y), float(c.fine_z), float(kMostParts)));
  float sum = 0.0;
  for (uint k = 0u; k < kRays; k++) {
    // Places of a sequence that fills the plane evenly.
    vec2 from = fract(float(kRays * thread + k) * vec2(0.7548776662466927, 0.5698402909980532));
    float depth = 0.0;
    for (uint i = 0u; i < parts; i++) {
      float down = (float(i) + 0.5) / float(parts);
      vec2 place = from - azimuth * across * down / vec2(c.width, c.depth);
      depth += density_at(vec3(place, 1.0 - down));
    }
    sum += exp(-depth * c.scale * height / (slope * float(parts)));
  }
  left[thread] = sum;
  barrier();
  if (thread > 0u) {
    return;
  }
  for (uint i = 1u; i < 64u; i++) {
    sum += left[i];
  }
  float depth = -log(max(sum / float(64u * kRays), 1e-30));
  imageStore(mean_out, ivec2(row, 0), vec4(depth * slope / height));
}
