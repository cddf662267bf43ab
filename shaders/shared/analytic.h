// What the closed-form skies know of a scene beyond its block; core/methods/analytic_sky.cpp fills it in.
// No include guard, as shared/scene.h. Every member is made of `real` alone.

const uint kAnalyticZenithDensity = 0u;
const uint kAnalyticExponential = 1u;

// A medium as nothing below `base` and an exponential above it, with the true profile's column, mean altitude and
// spread.
struct AnalyticMedium {
  real column;  // of density 1 from the ground to the top, km
  real base;    // km
  real scale_height;
};

// Light scattered more than once, isotropic, for a sun of irradiance 1; each as its logarithm.
struct AnalyticDiffuse {
  vec3 near;        // at the camera, 1/sr
  vec3 far;         // where the air above it ends
  vec3 ground;      // at the ground below it
  vec3 irradiance;  // of the sky on that ground, 1
  vec3 slope;       // how all change with the sun's zenith cosine
};

struct AnalyticData {
  AnalyticMedium media[kMaxMedia];
  AnalyticDiffuse diffuse;
  // Mean over medium i (row) of the share of medium j that stands higher: from the camera up, and from the ground to
  // the camera.
  real above[kMaxMedia * kMaxMedia];
  real below[kMaxMedia * kMaxMedia];
  vec3 horizon_mass;  // optical depth from the camera along the horizontal over that straight up
  real lit_height;    // mean altitude of the scattering above the camera, over the camera's, km
};
