// Where peaks of phase functions stand in the picture.

// A pixel of the tile at hand as a pixel of the whole picture.
uvec2 whole_pixel(uvec2 pixel) { return pixel + uvec2(scene.tile.x, scene.tile.y); }

// Distance from the sun, or from the point opposite to it, in distances of two pixels. A peak of a phase function may
// stand between four rays two pixels apart that do not see it.
float corners_from_peak(uvec2 pixel, vec3 direction) {
  uvec2 at = whole_pixel(pixel);
  vec3 next = view_ray(scene.camera, kProjection, float(at.x) + 0.5, float(at.y) + 2.5).direction;
  float off = min(length(direction - scene.sun.direction), length(direction + scene.sun.direction));
  return off / max(length(next - direction), 1e-12);
}
