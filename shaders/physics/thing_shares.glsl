// Light scattered more than once and sent back by slopes among terrain. The tables of moments know no terrain; what it
// hides of their light and adds to it stands in a grid around it as shares: of the light that the air at a place
// scatters toward the camera (`along`), of the light from all around there (`even`), and of the irradiance of the
// surface by the sky. thing_light.glsl makes them.
// The includer defines, for a place from 0 to 1 over the grid:
//   vec3 fetch_share(uint block, uint layer, vec2 place);  of the air; kShareAlong, kShareEven
//   vec3 fetch_slope_share(vec2 place);                    of the surface
//   real fetch_base(vec2 place);                           altitude that the layers' heights count from, km

const uint kShareAlong = 0u;
const uint kShareEven = 1u;

// A coordinate that is 0 in the middle of the map and 1 at its edge, as one of the grid from -1 to 1, and its inverse.
// The grid is even over the map and reaches beyond it, to where terrain changes nothing.
const real kMapShare = 0.6;

real grid_coordinate(real x) {
  real a = abs(x);
  real far = 1.0 - (1.0 - kMapShare) / (1.0 + max(a - 1.0, 0.0) * kMapShare / (1.0 - kMapShare));
  real g = a < 1.0 ? kMapShare * a : far;
  return x < 0.0 ? -g : g;
}

real map_coordinate(real g) {
  real a = min(abs(g), 1.0 - 1e-3);
  real far = 1.0 + ((1.0 - kMapShare) / (1.0 - a) - 1.0) * (1.0 - kMapShare) / kMapShare;
  real x = a < kMapShare ? a / kMapShare : far;
  return g < 0.0 ? -x : x;
}

vec2 grid_place(TerrainData t, real east, real north) {
  real x = 2.0 * map_column(t, east, north) / real(t.columns - 1u) - 1.0;
  real y = 2.0 * map_row(t, east, north) / real(t.rows - 1u) - 1.0;
  return vec2(0.5 + 0.5 * grid_coordinate(x), 0.5 + 0.5 * grid_coordinate(y));
}

// East and north of the grid's place.
vec2 map_from_grid(TerrainData t, vec2 place) {
  real across = 0.5 * map_coordinate(2.0 * place.x - 1.0) * real(t.columns - 1u) * t.texel;
  real up = -0.5 * map_coordinate(2.0 * place.y - 1.0) * real(t.rows - 1u) * t.texel;
  return vec2(t.centre_east + across * t.across_east - up * t.across_north,
              t.centre_north + across * t.across_north + up * t.across_east);
}

bool is_on_map(TerrainData t, real east, real north) {
  real column = map_column(t, east, north);
  real row = map_row(t, east, north);
  return column >= 0.0 && row >= 0.0 && column <= real(t.columns - 1u) && row <= real(t.rows - 1u);
}

// Height of terrain or ground.
real surface_height(TerrainData t, real east, real north) {
  real height = map_height(t, map_column(t, east, north), map_row(t, east, north));
  return is_on_map(t, east, north) ? max(height, 0.0) : 0.0;
}

// Layers stand closest over the surface, whose altitude is `base`.
real layer_altitude(TerrainData t, real base, real z) { return base + (light_top(t) - base) * z * z; }

real layer_coordinate(TerrainData t, real base, real h) {
  return sqrt(clamp((h - base) / max(light_top(t) - base, 1e-6), 0.0, 1.0));
}

// The share at a place in the air.
vec3 air_share(TerrainData t, uint block, real east, real north, real h) {
  vec2 place = grid_place(t, east, north);
  real z = layer_coordinate(t, fetch_base(place), h) * real(kLightLayers - 1u);
  uint low = min(uint(z), kLightLayers - 2u);
  real part = z - real(low);
  return fetch_share(block, low, place) * (1.0 - part) + fetch_share(block, low + 1u, place) * part;
}

// The share that a slope gets of its irradiance by a sky without terrain.
vec3 slope_share(TerrainData t, real east, real north) { return fetch_slope_share(grid_place(t, east, north)); }

