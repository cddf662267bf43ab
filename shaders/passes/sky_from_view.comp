#version 460
#extension GL_GOOGLE_include_directive : require
// The picture by one fetch a pixel from the sky-view table [H20 sec. 5.3]. Rays that end on the ground may march
// instead; listed directions march too, for their transmittance.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/scattering_tables.glsl"
#include "shared/ground_table.glsl"
#include "physics/march.glsl"
#include "physics/sky_view_mapping.glsl"
#include "shared/sky_output.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/edge_list.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 6) const uint kStepDistribution = 1u;
layout(constant_id = 11) const uint kSkyViewWidth = 192u;
layout(constant_id = 12) const uint kSkyViewHeight = 108u;
layout(constant_id = 13) const uint kSkyViewSkyRows = 72u;
layout(constant_id = 14) const uint kGroundMarches = 0u;
layout(set = 0, binding = 4) uniform sampler2D sky_view_lut;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint steps;
};

vec3 fetch_sky_view(SkyViewCoordinate c) {
  uint first = c.ground ? kSkyViewSkyRows : 0u;
  uint count = c.ground ? kSkyViewHeight - kSkyViewSkyRows : kSkyViewSkyRows;
  vec2 uv = vec2(texel_from_even(c.chord, float(kSkyViewWidth)),
                 texel_in_part(c.height, float(first), float(count), float(kSkyViewHeight)));
  return textureLod(sky_view_lut, uv, 0.0).rgb;
}

void main() {
  uvec2 thread = gl_GlobalInvocationID.xy;
  if (thread.x >= width || thread.y >= height) {
    return;
  }
  uvec2 pixel = pixel_of_thread(thread, width);
  ViewRay view = pixel_ray(pixel);
  PixelRays rays = rays_at(pixel, view);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(1.0);
  for (uint i = 0u; i < rays.count; i++) {
    WeightedRay one = weighted_ray(pixel, view, rays, i);
    vec3 light = fetch_sky_view(
        sky_view_coordinate(scene.planet, scene.camera.altitude, one.direction, scene.sun.direction));
    if (kGroundMarches != 0u || kProjection == kProjectionListed) {
      Ray ray = air_ray(one.direction);
      bool from_march = kGroundMarches != 0u && ray.at_ground;
      // The march takes no step on a ray of negative length.
      ray.length_ = from_march || kProjection == kProjectionListed ? ray.length_ : -1.0;
      PathRadiance path =
          march(scene.planet, scene.sun, ray, steps, kStepDistribution, scene.multiple_scattering_scale);
      transmittance = path.transmittance;
      light = from_march ? path.radiance : light;
    }
    radiance += one.share * light;
  }
  write_radiance(pixel, view.inside, radiance, transmittance);
}
