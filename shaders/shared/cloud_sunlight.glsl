// What a cloud leaves of the sun's light (passes/cloud_shadow.comp, cloud_bends.comp).
layout(set = 0, binding = 22) uniform sampler3D cloud_shadow_lut;

// Optical depth toward the sun. Places below the grid count too; a cloud that stands alone shades no place whose ray
// misses it. The texels hold the depth and how it bends along column, row and ray: linear steps alone would round off
// the cloud's edges by an eighth of a cell's depth, where its light comes from. A thin field's hold the depth alone,
// since devices without texture units load each component of each texel by itself.
float sun_depth_in(sampler3D table, CloudData c, vec3 place) {
  vec3 steps = vec3(textureSize(table, 0) - 1);
  float height = (c.top - c.base) * (1.0 - place.z);
  vec2 entry = place.xy + vec2(c.sunward_east, c.sunward_north) * height / vec2(c.width, c.depth);
  bool misses = c.repeats == 0u && (entry.x < 0.0 || entry.x > 1.0 || entry.y < 0.0 || entry.y > 1.0);
  vec3 at = vec3(entry - floor(entry), clamp(place.z, 0.0, 1.0)) * steps;
  vec4 texel = textureLod(table, (at + 0.5) / (steps + 1.0), 0.0);
  vec3 part = at - floor(at);
  float bend = c.thin == 1u ? 0.0 : dot(0.5 * part * (1.0 - part), texel.gba);
  return misses ? 0.0 : max(texel.r - bend, 0.0);
}

float sun_depth_at(vec3 place) { return sun_depth_in(cloud_shadow_lut, cloud(), place); }
