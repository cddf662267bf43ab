// Light of a cloud scattered more than once, along a pixel's ray. It changes from coarse cell to coarse cell, of which a
// step of the march may be a hundredth: it is found for parts of the ray, at their middles by what the camera sees.
layout(set = 0, binding = 23) uniform sampler3D cloud_source_lut;

const uint kMostParts = 8u;     // that the march puts aside
const float kPartOfCell = 0.5;  // length of a part over a coarse cell's
const float kThinPart = 3.0;    // likewise in a thin field

float seen_harmonics[kCloudMoments];  // of the direction in which light comes to the camera

vec4 source_block(uint block, vec3 place) {
  CloudData c = cloud();
  float columns = float(c.coarse_x + 1u);
  float x = (float(block) * columns + cell_texel(place.x, c.coarse_x)) / (columns * float(kCloudBlocks));
  float y = cell_texel(place.y, c.coarse_y) / float(c.coarse_y + 1u);
  float z = (place.z * float(c.coarse_z) + 1.0) / float(c.coarse_z + 2u);  // a slice beyond base and top each
  return textureLod(cloud_source_lut, vec3(x, y, z), 0.0);
}

CloudSource source_at(vec3 place) {
  float values[4u * kCloudBlocks];
  UNROLL for (uint b = 0u; b < kCloudBlocks; b++) {
    vec4 texel = source_block(b, place);
    values[4u * b] = texel.x;
    values[4u * b + 1u] = texel.y;
    values[4u * b + 2u] = texel.z;
    values[4u * b + 3u] = texel.w;
  }
  CloudSource source;
  source.sun = 0.0;
  UNROLL for (uint q = 0u; q < kCloudMoments; q++) {
    source.sun += values[q] * seen_harmonics[q];
  }
  source.sun = max(source.sun, 0.0);
  source.sky = max(values[kCloudSky] * seen_harmonics[0] + values[kCloudSky + 1u] * seen_harmonics[2] +
                       values[kCloudSky + 2u] * seen_harmonics[6],
                   0.0);
  source.ground = max(values[kCloudGround] * seen_harmonics[0] + values[kCloudGround + 1u] * seen_harmonics[2] +
                          values[kCloudGround + 2u] * seen_harmonics[6],
                      0.0);
  return source;
}

// A part of a stretch.
struct CloudPart {
  float from;   // km
  float taken;  // share of the light from behind it that it takes out, over all of the way
  float reach;  // sum of distances times light taken out
  uint sheet;   // the stretch, counted from those put aside before
};

CloudPart empty_part() { return CloudPart(0.0, 0.0, 0.0, 0u); }

// Adds a step that begins at `from`, takes out this share and has its middle at t.
CloudPart with_step_of_part(CloudPart part, float from, float taken, float t) {
  part.from = part.taken > 0.0 ? part.from : from;
  part.taken += taken;
  part.reach += taken * t;
  return part;
}

struct CloudParts {
  CloudPart of[kMostParts];
  uint count;
};

// The length of a part of a ray that climbs or falls so steeply, km.
float length_of_parts(vec3 direction, float climb) {
  CloudData c = cloud();
  vec3 per_km = vec3(c.coarse_x, c.coarse_y, c.coarse_z) / vec3(c.width, c.depth, c.top - c.base);
  float cells = c.thin == 1u ? kThinPart : kPartOfCell;
  return cells / max(max(abs(direction.x) * per_km.x, abs(direction.z) * per_km.y), climb * per_km.z);
}

