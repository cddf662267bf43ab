// Sizes of the grid of light among terrain (shaders/physics/thing_shares.glsl).

const uint kLightLayers = 6u;  // of air
const uint kLightDirections = 64u;
const uint kLightSteps = 6u;  // along each
const uint kOpenRows = 16u;   // altitudes of the light without terrain
const uint kOpenSlices = 8u;  // distances up to which it is kept, beside the whole ray's

// How the air's other light is dimmed by terrain on a ray by tables.
const uint kDimmedNone = 0u;
const uint kDimmedFroxels = 1u;
const uint kDimmedSteps = 2u;
