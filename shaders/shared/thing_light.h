// Sizes of the grid of light among terrain (shaders/physics/thing_shares.glsl).
#ifndef AIRLIGHT_THING_LIGHT_H
#define AIRLIGHT_THING_LIGHT_H

const uint kLightLayers = 6u;  // of air
const uint kLightDirections = 64u;
const uint kLightSteps = 6u;  // along each
const uint kOpenRows = 16u;   // altitudes of the light without terrain
const uint kOpenSlices = 8u;  // distances up to which it is kept, beside the whole ray's

// Texels of the light of caps of the sky (shaders/physics/sky_caps.glsl).
const uint kCapAngles = 12u;  // from the sun
const uint kCapTurns = 7u;    // around it
const uint kCapSizes = 6u;
const uint kCapRings = 12u;   // of what they are sums over
const uint kCapSpokes = 16u;

// How the air's other light is dimmed by terrain on a ray by tables.
const uint kDimmedNone = 0u;
const uint kDimmedFroxels = 1u;
const uint kDimmedSteps = 2u;

const float kNoTerrain = 1e9f;  // km: a corner of a pixel that sees no terrain
const float kBodySeen = 2.0f;   // in place of a share of the sun: a corner that sees a body

// Which blocks of kThingBlock x kThingBlock pixels a pass over things renders. Blocks of the sky alone are one pass,
// where no pixel shows a thing or the ground or needs several rays. A second are others that are simple: over terrain
// those where the air up to what they show is known from few of their rays; without terrain those of ground from which
// bodies stand aside. The third holds all that are not.
const uint kTilesAll = 0u;
const uint kTilesOfSky = 1u;
const uint kTilesOfThings = 2u;
const uint kTilesExact = 3u;
const uint kThingBlock = 8u;
const uint kThingSquare = 16u;  // pixels along a side of 2 x 2 blocks
const uint kTileWords = 16u;  // of their list, before the blocks

#endif
