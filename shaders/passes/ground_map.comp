#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the ground by its map to a picture whose ground is black: the part of each pixel below the true horizon, lit by
// sun and sky, seen through the air before it.
#include "shared/device.glsl"
#include "shared/tables.glsl"
#include "shared/picture_ray.glsl"
#include "shared/horizon_pixels.glsl"
#include "shared/ground.h"

bool has_ground_maps() { return true; }

#include "shared/ground_maps.glsl"
#include "physics/ground_view.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 2) uniform sampler2D ground_view;            // mean extinction up to the ground
layout(set = 0, binding = 3) uniform sampler2D ground_irradiance_lut;  // the sky's, over (1 + mu_sun)/2
layout(scalar, set = 0, binding = 8) readonly buffer Directions { vec4 values[]; } directions;
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;
layout(constant_id = 28) const uint kIrradianceColumns = 64u;  // of ground_irradiance_lut; 0: this sky sends no light
layout(constant_id = 29) const uint kViewColumns = 256u;
layout(push_constant, scalar) uniform Push {
  uint width;
  uint height;
  uint vectors;  // of each listed direction (core/methods/sky_pass.h)
};

ViewRay ray_here(uvec2 pixel) {
  if (kProjection == kProjectionListed) {
    ViewRay ray;
    ray.direction = directions.values[pixel.x].xyz;
    ray.inside = true;
    return ray;
  }
  return picture_ray(pixel);
}

vec3 sky_on_ground(float mu_sun) {
  if (kIrradianceColumns == 0u) {
    return vec3(0.0);
  }
  float u = texel_from_unit(0.5 + 0.5 * mu_sun, float(kIrradianceColumns));
  return textureLod(ground_irradiance_lut, vec2(u, 0.5), 0.0).rgb;
}

vec3 through_air(GroundPlace place) {
  float way = air_before_ground(scene.planet, scene.camera.altitude, place);
  float x = unit_from_way(view_range(scene.planet, scene.camera.altitude), way);
  return exp(-way * textureLod(ground_view, vec2(texel_from_unit(x, float(kViewColumns)), 0.5), 0.0).rgb);
}

// Angle that the pixel spans along its wider side.
float pixel_angle(uvec2 pixel) {
  if (kProjection == kProjectionListed) {
    return 0.0;
  }
  vec2 at = pixel_centre(pixel);
  vec3 across = view_ray(scene.camera, kProjection, at.x + 0.49, at.y).direction -
                view_ray(scene.camera, kProjection, at.x - 0.49, at.y).direction;
  vec3 down = view_ray(scene.camera, kProjection, at.x, at.y + 0.49).direction -
              view_ray(scene.camera, kProjection, at.x, at.y - 0.49).direction;
  return max(length(across), length(down)) / 0.98;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) {
    return;
  }
  ViewRay view = ray_here(pixel);
  PixelRays rays = rays_at(pixel, view);
  float share = rays.count > 1u ? rays.ground : 1.0;
  vec3 direction = weighted_ray(pixel, view, rays, rays.count - 1u).direction;
  GroundPlace place = ground_place(scene.planet, scene.camera.altitude, direction);
  if (!view.inside || !place.hit || share <= 0.0) {
    return;
  }
  PlaceSun sun = sun_at(scene.planet, Place(direction * place.distance_, 0.0, place.up), scene.sun.direction);
  vec3 beam = transmittance_to_sun(scene.planet, 0.0, sun.mu) * sun_fade(scene.sun, sun.mu);
  Ground ground = ground_seen(scene.planet, place, direction, pixel_angle(pixel));
  vec3 light = ground_sends(ground, place.up, sun.seen, -direction, beam, sky_on_ground(sun.mu));
  light *= share * through_air(place) * scene.sun.irradiance;
  uint at = kProjection == kProjectionListed ? vectors * pixel.x : pixel.y * scene.tile.width + pixel.x;
  radiance_out.values[at] += vec4(light, 0.0);
}
