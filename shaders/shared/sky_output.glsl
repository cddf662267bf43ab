// Where a sky pass gets its view rays and puts its radiance: the camera's pixels, or listed directions.

layout(constant_id = 4) const uint kProjection = 0u;

layout(scalar, set = 0, binding = 8) readonly buffer Directions { vec4 values[]; } directions;
// Rows from the top; for listed directions radiance and transmittance in turn.
layout(scalar, set = 0, binding = 9) writeonly buffer Radiance { vec4 values[]; } radiance_out;

ViewRay pixel_ray(uvec2 pixel) {
  if (kProjection == kProjectionListed) {
    ViewRay ray;
    ray.direction = directions.values[pixel.x].xyz;
    ray.inside = true;
    return ray;
  }
  return view_ray(scene.camera, kProjection, float(pixel.x) + 0.5, float(pixel.y) + 0.5);
}

Ray air_ray(vec3 direction) {
  return ray_in_atmosphere(scene.planet, scene.camera.altitude, direction.y, scene.sun.direction.y,
                           dot(direction, scene.sun.direction));
}

void write_radiance(uvec2 pixel, bool inside, vec3 radiance, vec3 transmittance) {
  if (kProjection == kProjectionListed) {
    radiance_out.values[2u * pixel.x] = vec4(radiance, 1.0);
    radiance_out.values[2u * pixel.x + 1u] = vec4(transmittance, 1.0);
    return;
  }
  radiance_out.values[pixel.y * scene.camera.width + pixel.x] = inside ? vec4(radiance, 1.0) : vec4(0.0);
}
