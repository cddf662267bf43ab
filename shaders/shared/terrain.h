// Terrain as the shaders see it, at the start of the buffer of heights; the same text in C++ (core/physics). Places on
// the ground are east and north of the camera's ground point in km, by azimuthal equidistance, in which a ray from the
// camera is a straight line.

const uint kTerrainLevels = 14u;

struct TerrainData {
  // The map of heights: columns run along `across`, rows against the direction 90 degrees left of it.
  real centre_east;
  real centre_north;
  real across_east;
  real across_north;
  real texel;  // km between heights
  uint columns;
  uint rows;
  uint levels;                       // of maxima; level 0 is the cells between four heights
  uint level_first[kTerrainLevels];  // index of each level's first maximum in the buffer
  uint colour_columns;
  uint colour_rows;
  // The table of shadows: each row runs along the way to the sun; rows are counted from the left of that way.
  real sunward_east;
  real sunward_north;
  real shadow_along;  // of the first texel, along the way to the sun, km
  real shadow_aside;  // of the first texel, across it, km
  real shadow_texel;  // km
  uint shadow_columns;
  uint shadow_rows;
  real shadow_reach;  // greatest distance of a shadow from the camera, km along the ground
  // A texel of it has the altitude up to which the sun is wholly hidden in its upper 21 bits, and the root of the
  // penumbra's height above in the lower 11.
  real shadow_low;   // km: the altitude of 0, deep in the planet, where there is no shadow
  real shadow_step;  // km: of each further one
  real shadow_soft;  // km: the height of a penumbra whose root is 1
};
