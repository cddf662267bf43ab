#version 460
#extension GL_GOOGLE_include_directive : require
// A pixel from the picture's table of factors: one fetch for each medium that is not folded, times its phase function,
// and one for all other light. The aureole is as sharp as the phase function, however coarse the table.
#define AIRLIGHT_STOKES
#include "shared/device.glsl"
#include "shared/sky_table.glsl"
#include "shared/stokes.glsl"
bool polarised() { return stokes(); }
#include "physics/polarisation.glsl"
#include "physics/stokes.glsl"
#include "shared/sky_output.glsl"
#include "shared/stokes_shown.glsl"
#include "physics/sky_table.glsl"
#include "physics/space_table.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/edge_list.glsl"

const uint kRestBlocks = kStokes != kStokesNone ? 3u : 1u;
#include "shared/factor_fetch.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 39) const uint kAdds = 0u;  // not 0: to the picture, at its edges in place of the middle ray
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
};

Stokes light_at(vec3 direction) {
  FactorPlace at = factor_place(direction);
  Stokes light;
  light.i = fetch_shared(diffuse_block(), at);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    light.i += single_at(i, at);
  }
  return stokes() ? shown(with_stokes(light, diffuse_block() + 1u, at, direction), direction) : light;
}

void main() {
  uvec2 thread = gl_GlobalInvocationID.xy;
  if (thread.x >= width || thread.y >= height || (kAdds != 0u && repeats_pixel(thread, width))) {
    return;
  }
  uvec2 pixel = pixel_of_thread(thread, width);
  ViewRay view = pixel_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  Stokes sum = no_light();
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    sum = with_share(sum, light_at(one.direction), one.share);
  }
  if (kAdds == 0u) {
    write_light(pixel, view.inside, sum, vec3(1.0));
    return;
  }
  if (kEdges == kEdgesListed) {
    sum = with_share(sum, light_at(view.direction), -1.0);
  }
  add_radiance(pixel, view.inside, sum.i);
}
