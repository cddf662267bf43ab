// Light without terrain, where the light among terrain is compared with it (thing_light.glsl): from a set of
// directions, up to a set of distances, at altitudes among terrain.

// The highest place of the terrain, km.
real terrain_top(TerrainData t) { return terrain_height(terrain_level(t.levels - 1u)); }

// Altitude of the grid's highest layer: above, shares are taken as they are there.
real light_top(TerrainData t) { return 2.5 * terrain_top(t); }

const uint kOpenSingle = 0u;
const uint kOpenDiffuse = 1u;
const uint kOpenThrough = 2u;

// Directions in rings about the sun, which are the closer the nearer they are: light comes mostly from there.
const uint kLightRings = 8u;
const uint kLightSpokes = 8u;

real ring_angle(real ring) {
  real x = ring / real(kLightRings);
  return kPi * x * sqrt(x);
}

vec3 light_direction(uint i, vec3 sun) {
  real ring = real(i / kLightSpokes) + 0.5;
  real angle = ring_angle(ring);
  real turn = 2.0 * kPi * (real(i % kLightSpokes) + 0.5 * ring) / real(kLightSpokes);
  real level = sqrt(sun.x * sun.x + sun.z * sun.z);
  vec3 aside = level > 1e-6 ? vec3(-sun.z / level, 0.0, sun.x / level) : vec3(1.0, 0.0, 0.0);
  vec3 above = vec3(sun.y * aside.z, sun.z * aside.x - sun.x * aside.z, -sun.y * aside.x);
  return sun * cos(angle) + (aside * cos(turn) + above * sin(turn)) * sin(angle);
}

// Solid angle that a direction stands for.
real light_weight(uint i) {
  real ring = real(i / kLightSpokes);
  return (cos(ring_angle(ring)) - cos(ring_angle(ring + 1.0))) * 2.0 * kPi / real(kLightSpokes);
}

// Altitudes without terrain: rows from 0 up to light_top().
real open_altitude(TerrainData t, real row) {
  real y = row / real(kOpenRows - 1u);
  return light_top(t) * y * y;
}

real open_row(TerrainData t, real h) { return sqrt(clamp(h / light_top(t), 0.0, 1.0)) * real(kOpenRows - 1u); }

// Distances along a direction: up to where its rays leave the terrain's altitudes. One slice more holds the whole ray.
real open_reach(TerrainData t, real mu) {
  real across = t.texel * real(max(t.columns, t.rows));
  real height = mu > 0.0 ? 1.05 * terrain_top(t) : light_top(t);
  return min(across, height / max(abs(mu), 1e-6));
}

real open_distance(real reach, real slice) {
  real z = slice / real(kOpenSlices);
  return reach * z * z;
}

real open_slice(real reach, real distance_) { return real(kOpenSlices) * sqrt(clamp(distance_ / reach, 0.0, 1.0)); }

