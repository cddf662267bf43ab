// Light without terrain, where the light among terrain is compared with it (thing_light.glsl): from a set of
// directions, up to a set of distances, at altitudes among terrain.

// The highest place of the terrain, km.
real terrain_top(TerrainData t) { return terrain_height(terrain_level(t.levels - 1u)); }

// Altitude of the grid's highest layer: above, shares are taken as they are there.
real light_top(TerrainData t) { return 2.5 * terrain_top(t); }

const uint kOpenSingle = 0u;
const uint kOpenDiffuse = 1u;
const uint kOpenThrough = 2u;

// Directions, each of an elevation of its own, which are the closer the nearer they are to level: there the sky is
// brightest, and terrain hides it. Their azimuths go on by the golden section of a turn from the sun's.
const uint kLightBelow = 16u;  // of the directions, those below level

// Sine of the elevation at which the slice of direction `edge` begins: -1 at 0, 1 at kLightDirections.
real light_level(real edge) {
  real below = real(kLightBelow);
  real y = edge < below ? (below - edge) / below : (edge - below) / real(kLightDirections - kLightBelow);
  real sine = sin(0.5 * kPi * y * y * sqrt(y));
  return edge < below ? -sine : sine;
}

// `mirrored`: on the other side of the plane of sun and zenith, where light without terrain is the same.
vec3 light_direction(uint i, bool mirrored, vec3 sun) {
  const real kGolden = 0.618033989;
  real up = light_level(real(i) + 0.5);
  real along = sqrt(max(1.0 - up * up, 0.0));
  real turns = real(i) * kGolden + 0.25;
  real turn = (mirrored ? -2.0 : 2.0) * kPi * (turns - floor(turns));
  real level = sqrt(sun.x * sun.x + sun.z * sun.z);
  real east = level > 1e-6 ? sun.x / level : 0.0;
  real south = level > 1e-6 ? sun.z / level : 1.0;
  return vec3(along * (east * cos(turn) - south * sin(turn)), up, along * (south * cos(turn) + east * sin(turn)));
}

// Solid angle that a direction stands for.
real light_weight(uint i) { return 2.0 * kPi * (light_level(real(i) + 1.0) - light_level(real(i))); }

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

