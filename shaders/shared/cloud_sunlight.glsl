// What a cloud leaves of the sun's light (passes/cloud_shadow.comp).
layout(set = 0, binding = 22) uniform sampler3D cloud_shadow_lut;

// Optical depth toward the sun. Places below the grid count too.
float sun_depth_at(vec3 place) {
  CloudData c = cloud();
  float height = (c.top - c.base) * (1.0 - place.z);
  vec2 entry = place.xy + vec2(c.sunward_east, c.sunward_north) * height / vec2(c.width, c.depth);
  vec2 cells = vec2(c.fine_x, c.fine_y);
  vec2 texel = (entry - floor(entry)) * cells + 0.5;
  float slices = float(c.fine_z + 1u);
  float slice = (clamp(place.z, 0.0, 1.0) * float(c.fine_z) + 0.5) / slices;
  return textureLod(cloud_shadow_lut, vec3(texel / (cells + 1.0), slice), 0.0).r;
}
