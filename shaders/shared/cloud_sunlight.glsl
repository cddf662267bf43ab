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

// The same for a place in the grid, where the table's linear steps would round off the cloud's edge: the first cells
// toward the sun are crossed by themselves.
float near_sun_depth(vec3 place) {
  const uint kSamples = 4u;
  const float kCells = 1.5;     // to be crossed in each direction
  const float kMostCells = 3.0;  // in the direction that is fastest
  CloudData c = cloud();
  vec3 rise = vec3(vec2(c.sunward_east, c.sunward_north) / vec2(c.width, c.depth), 1.0 / (c.top - c.base));
  vec3 cells = abs(rise) * vec3(c.fine_x, c.fine_y, c.fine_z);
  float climb = min(kCells / max(min(min(cells.x, cells.y), cells.z), 1e-6),
                    kMostCells / max(max(cells.x, cells.y), cells.z));  // km
  climb = min(climb, max(1.0 - place.z, 0.0) * (c.top - c.base));
  float way = climb * length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float sum = 0.0;
  for (uint i = 0u; i < kSamples; i++) {
    sum += density_at(place + rise * (climb * (float(i) + 0.5) / float(kSamples)));
  }
  return sum * (way / float(kSamples)) + sun_depth_at(place + rise * climb);
}
