// A sky pass's view rays and its output of radiance, for the camera's pixels or for listed directions.

#include "shared/picture_ray.glsl"

layout(scalar, set = 0, binding = 8) readonly buffer Directions { vec4 values[]; } directions;
// Rows from the top. For listed directions radiance and transmittance alternate.
layout(scalar, set = 0, binding = 9) buffer Radiance { vec4 values[]; } radiance_out;

ViewRay pixel_ray(uvec2 pixel) {
  if (kProjection == kProjectionListed) {
    ViewRay ray;
    ray.direction = directions.values[pixel.x].xyz;
    ray.inside = true;
    return ray;
  }
  return picture_ray(pixel);
}

void write_radiance(uvec2 pixel, bool inside, vec3 radiance, vec3 transmittance) {
  if (kProjection == kProjectionListed) {
    radiance_out.values[2u * pixel.x] = vec4(radiance, 1.0);
    radiance_out.values[2u * pixel.x + 1u] = vec4(transmittance, 1.0);
    return;
  }
  radiance_out.values[pixel.y * scene.tile.width + pixel.x] = inside ? vec4(radiance, 1.0) : vec4(0.0);
}

// Adds to a picture of the camera.
void add_radiance(uvec2 pixel, bool inside, vec3 radiance) {
  radiance_out.values[pixel.y * scene.tile.width + pixel.x].rgb += inside ? radiance : vec3(0.0);
}

#ifdef AIRLIGHT_STOKES
// Of listed directions Q and U may follow.
void write_light(uvec2 pixel, bool inside, Stokes light, vec3 transmittance) {
  if (kProjection == kProjectionListed && kStokes == kStokesKept) {
    radiance_out.values[4u * pixel.x] = vec4(light.i, 1.0);
    radiance_out.values[4u * pixel.x + 1u] = vec4(transmittance, 1.0);
    radiance_out.values[4u * pixel.x + 2u] = vec4(light.q, 1.0);
    radiance_out.values[4u * pixel.x + 3u] = vec4(light.u, 1.0);
    return;
  }
  write_radiance(pixel, inside, light.i, transmittance);
}
#endif
