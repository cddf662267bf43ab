// Terrain as the shaders see it, the same text in C++ (core/physics): what opens the buffer of heights.
// Places on the ground are east and north of the camera's ground point in km, by azimuthal equidistance: a ray from the
// camera is a straight line there.

const uint kTerrainLevels = 14u;

struct TerrainData {
  // The map of heights: columns rise along `across`, rows fall along what stands 90 degrees left of it.
  real centre_east;
  real centre_north;
  real across_east;
  real across_north;
  real texel;  // km between heights
  uint columns;
  uint rows;
  uint levels;                       // of maxima; level 0 are the cells between four heights
  uint level_first[kTerrainLevels];  // where a level's maxima begin behind the heights
  uint colour_columns;
  uint colour_rows;
  // The table of shadows: rows along the way to the sun, counted from its left.
  real sunward_east;
  real sunward_north;
  real shadow_along;  // of the first texel, km along that way
  real shadow_aside;  // and across it
  real shadow_texel;  // km
  uint shadow_columns;
  uint shadow_rows;
};
