// Light scattered in a cloud, as the passes that find it read it (physics/cloud_light.glsl). The cloud's frame has x to
// the east, y to the north and z up; lengths in km.
// No include guard: C++ includes it once with real = float and once with real = double.

const uint kCloudMoments = 9u;     // of degree 0 to 2
const uint kCloudRings = 6u;       // zenith cosines of ordinates
const uint kCloudOrdinates = 48u;  // eight azimuths each

const uint kCloudPeakRows = 24u;  // depths at which the table of the forward peak stands
const uint kCloudMeanRows = 32u;  // slopes at which the table of a field's mean depth stands

// A direction in which light travels.
struct CloudOrdinate {
  vec3 direction;
  real weight;                    // solid angle, sr
  real lowest;                    // of the cosines of zenith angles that it stands for, as many as its weight says
  real harmonics[kCloudMoments];  // cloud_harmonic() of the direction
};

// What a meeting with a drop makes of the harmonics.
struct CloudScattering {
  real kept[kCloudMoments];      // by harmonic: albedo times the Legendre moment, both delta-scaled
  real sunlight[kCloudMoments];  // the harmonics of the sun's light, of irradiance 1
};

// The edge of a cloud's water, which noise carves finer than the grid's cells (physics/cloud_edge.glsl).
struct CloudEdge {
  real tiles;        // of the noise across the grid, a whole number; 0: nothing is finer than the grid
  real tile_levels;  // tiles from base to top
  real carving;      // km at most that the noise takes off
  real soft;         // km over which the extinction falls to 0
  real low;          // 1/km, extinction inside the cloud at the base, and at the top
  real high;
};

// A cloud as the picture reads it. Fine cells hold the extinction, coarse ones the light.
struct CloudData {
  uint fine_x;
  uint fine_y;
  uint fine_z;
  uint coarse_x;
  uint coarse_y;
  uint coarse_z;
  uint repeats;
  uint thin;  // 1: the field is thin all over, and light changes little from cell to cell
  // Of the scaled extinction, what turns light aside: (1 - a g) / (1 - a f), a the single scattering albedo, g the mean
  // cosine of scattering, f the share of it that counts as unscattered.
  real turning;
  real west;  // of the grid's corner from the point under the camera
  real south;
  real width;  // of the whole grid
  real depth;
  real base;  // altitudes
  real top;
  real scale;         // of the extinction, by delta scaling
  real albedo;        // share of the light met that is scattered
  real sunward_east;  // km that the sun's rays move per km of height
  real sunward_north;
  CloudEdge edge;
};

// Light from all around that is not the sun's, over that of a clear sky: a rest, and what the light at a place that
// passes/cloud_around.comp has found counts: of the sun, of sky and ground.
struct CloudAround {
  vec3 rest;
  vec3 sun;
  vec3 sky;
  vec3 ground;
};

// The light below and above a cloud, over that of a clear sky.
struct CloudLight {
  vec3 below;         // all light that ground and base get from above
  vec3 rising;        // light from below at the base, which ground and air send
  vec3 air_below;     // light from all around that is not the sun's, below the cloud, the mean of the field
  vec3 air_above;     // likewise above it
  real direct;        // of the sun's light, the share that passes through unscattered
  real forward;       // likewise unscattered or scattered forward alone (CloudData::turning)
  vec3 above;         // what it adds to light from below on planes above it, over all light from above there
  vec3 returned;      // what of this the air above sends down on it again, over the same
  vec3 falling;       // the mean below the field of the light that passes/cloud_around.comp has found
  CloudAround under;  // below the cloud, at its base, and at its top
  CloudAround at_base;
  CloudAround at_top;
  vec3 near_sun;      // light from about the sun on the ground, over the sun's
  vec3 fading;        // share of what the cloud changes above it that the air up to space takes
  real scale_height;  // km, of the air above the top
};
