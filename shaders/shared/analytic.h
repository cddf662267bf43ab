// Inputs of the closed-form skies that the scene block lacks; core/methods/analytic_sky.cpp fills them in. It has no
// include guard, like shared/scene.h. Every member consists of `real` alone.

const uint kAnalyticZenithDensity = 0u;
const uint kAnalyticExponential = 1u;

// A medium as an exponential above `base` and nothing below it, with the true profile's column, mean altitude and
// spread.
struct AnalyticMedium {
  real column;  // density 1, from the ground to the top, km
  real base;    // km
  real scale_height;
};

// Light scattered more than once, isotropic, for a sun of irradiance 1. Each member is a logarithm.
struct AnalyticDiffuse {
  vec3 near;        // at the camera, 1/sr
  vec3 far;         // where the air above the camera ends
  vec3 ground;      // at the ground below the camera
  vec3 irradiance;  // of the sky on that ground, 1
  vec3 slope;       // how all change with the sun's zenith cosine
};

struct AnalyticData {
  AnalyticMedium media[kMaxMedia];
  AnalyticDiffuse diffuse;
  // Share of medium j that stands higher than a point, as its mean over medium i (row): `above` from the camera up,
  // `below` from the ground to the camera.
  real above[kMaxMedia * kMaxMedia];
  real below[kMaxMedia * kMaxMedia];
  vec3 horizon_mass;  // optical depth from the camera along the horizontal over that along the vertical
  real lit_height;    // mean altitude above the camera of the scattering there, km
};
