// The ground's map as the shaders see it, the same text in C++ (core/physics).
// Places on the planet are unit vectors from its centre.

const uint kGroundLevels = 14u;
const uint kGlintShares = 33u;

// A map is a picture over the planet, rows from the north pole, twice as many columns as rows, from longitude -180
// eastward. Its levels are means of it: each has half the rows of the one before.
struct GroundShape {
  vec3 pole;       // the planet's axes in the camera's frame: north pole,
  vec3 greenwich;  // longitude 0 on the equator,
  vec3 east;       // longitude 90 degrees there
  uint albedo_rows;
  uint albedo_levels;
  uint water_rows;
  uint water_levels;
  real slope_variance;  // of the ocean's surface; 0: there is no ocean
};

struct GroundData {
  GroundShape shape;
  uint albedo_first[kGroundLevels];  // index of each level's first texel
  uint water_first[kGroundLevels];
  real glint_share[kGlintShares];  // share of the sun's light that waves mirror, by the root of its zenith cosine
};
