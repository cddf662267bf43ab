#version 460
#extension GL_GOOGLE_include_directive : require
// The closed-form skies, one pixel a thread: no march, no table.
#include "shared/device.glsl"
#include "shared/analytic.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 5) const uint kVariant = 0u;
layout(constant_id = 6) const uint kScatteringMedia = 0u;  // bit i
layout(scalar, set = 0, binding = 1) readonly buffer Analytic { AnalyticData values; } analytic;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

AnalyticMedium analytic_medium(uint i) { return analytic.values.media[i]; }
AnalyticDiffuse analytic_diffuse() { return analytic.values.diffuse; }
float share_above(uint i, uint j) { return analytic.values.above[i * kMaxMedia + j]; }
float share_below(uint i, uint j) { return analytic.values.below[i * kMaxMedia + j]; }
vec3 horizon_mass() { return analytic.values.horizon_mass; }
float lit_height() { return analytic.values.lit_height; }
bool scatters(uint i) { return (kScatteringMedia >> i & 1u) != 0u; }

#include "physics/columns.glsl"
#include "physics/analytic.glsl"
#include "physics/zenith_density.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = pixel_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(0.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    Ray ray = air_ray(one.direction);
    PathRadiance path;
    if (kVariant == kAnalyticExponential) {
      path = analytic_exponential(scene.planet, scene.sun, ray, scene.sun.direction.y);
    } else {
      path = analytic_zenith_density(scene.planet, scene.sun, ray);
    }
    radiance += one.share * path.radiance;
    transmittance += one.share * path.transmittance;
  }
  write_radiance(pixel, view.inside, radiance, transmittance);
}
