// The view ray that a texel of the sky-view table stands for.

Ray sky_view_texel_ray(ivec2 texel, ivec2 size, int sky_rows) {
  SkyViewCoordinate c;
  vec2 uv = (vec2(texel) + 0.5) / vec2(size);
  c.chord = even_from_texel(uv.x, float(size.x));
  c.ground = texel.y >= sky_rows;
  c.height = part_from_texel(uv.y, c.ground ? float(sky_rows) : 0.0,
                             c.ground ? float(size.y) - float(sky_rows) : float(sky_rows), float(size.y));
  return sky_view_ray(scene.planet, scene.camera.altitude, c, scene.sun.direction.y);
}
