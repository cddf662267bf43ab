// The view ray of a pixel of the tile at hand, and its part inside the air.

layout(constant_id = 4) const uint kProjection = 0u;

ViewRay picture_ray(uvec2 pixel) {
  return view_ray(scene.camera, kProjection, float(pixel.x + scene.tile.x) + 0.5, float(pixel.y + scene.tile.y) + 0.5);
}

Ray air_ray(vec3 direction) {
  return ray_in_atmosphere(scene.planet, scene.camera.altitude, direction.y, scene.sun.direction.y,
                           dot(direction, scene.sun.direction));
}
