// Sizes of the grid of light among terrain (shaders/physics/thing_shares.glsl).
#ifndef AIRLIGHT_THING_LIGHT_H
#define AIRLIGHT_THING_LIGHT_H

const uint kLightLayers = 6u;  // of air
const uint kLightDirections = 64u;
const uint kLightSteps = 6u;  // along each
const uint kOpenRows = 16u;   // altitudes of the light without terrain
const uint kOpenSlices = 8u;  // distances up to which it is kept, beside the whole ray's

// How the air's other light is dimmed by terrain on a ray by tables.
const uint kDimmedNone = 0u;
const uint kDimmedFroxels = 1u;
const uint kDimmedSteps = 2u;

const float kNoTerrain = 1e9f;  // km: a corner of a pixel that sees no terrain

// Which blocks of kThingBlock x kThingBlock pixels a pass over things renders. Where the air up to what a block shows
// is known from few of its rays, blocks of the sky alone are one pass, where no pixel shows a thing or the ground or
// needs several rays, and the others a second; the third asks the tables for the air of each ray.
const uint kTilesAll = 0u;
const uint kTilesOfSky = 1u;
const uint kTilesOfThings = 2u;
const uint kTilesExact = 3u;
const uint kThingBlock = 8u;
const uint kTileWords = 16u;  // of their list, before the blocks

#endif
