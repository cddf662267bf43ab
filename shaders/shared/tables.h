// Codes and sizes that host and shaders share: specialisation-constant values and workgroup shapes.

const uint kProjectionPerspective = 0u;
const uint kProjectionEquirectangular = 1u;
const uint kProjectionFisheye = 2u;
const uint kProjectionCube = 3u;
const uint kProjectionOctahedral = 4u;
const uint kProjectionListed = 5u;  // directions from a buffer

const uint kCubeStack = 0u;  // OpenEXR's: six faces down
const uint kCubeStrip = 1u;
const uint kCubeCross = 2u;

const uint kStepsUniform = 0u;
const uint kStepsQuadratic = 1u;
const uint kStepsGaussLegendre = 2u;

// Pixels at the planet's edge.
const uint kEdgesLeftOut = 0u;
const uint kEdgesFound = 1u;
const uint kEdgesListed = 2u;  // in `directions`: x and y of a pixel of the tile

// Q and U of a picture's light.
const uint kStokesNone = 0u;
const uint kStokesKept = 1u;      // put out beside it
const uint kStokesFiltered = 2u;  // seen through the camera's polarising filter

// Part of the picture that a march takes.
const uint kPartWhole = 0u;
const uint kPartHalf = 1u;       // the corners of every second pixel in both directions
const uint kPartUpsampled = 2u;  // all pixels, from those corners

// Place in each step of a march where its light is taken.
const uint kJitterNone = 0u;   // in the middle
const uint kJitterFixed = 1u;  // at the same place of every step
const uint kJitterBlueNoise = 2u;

// Things of a scene, as bits.
const uint kHasTerrain = 1u;
const uint kHasSpheres = 2u;
const uint kHasGroundMaps = 4u;  // planet.albedo_map, planet.ocean
const uint kBodiesAside = 8u;    // no ray of the pass meets one, or crosses its shadow

// Shadows of things in the air. To the march all but none are the same.
const uint kShaftsNone = 0u;
const uint kShaftsFroxels = 1u;
const uint kShaftsExact = 2u;

const uint kToneAces = 0u;
const uint kToneReinhard = 1u;
const uint kToneReinhardLuminance = 2u;
const uint kToneExponential = 3u;
const uint kToneClamp = 4u;
const uint kToneNone = 5u;

// Four bits per medium hold its density profile (physics/medium.glsl); four more its phase function
// (physics/phase.glsl): three of code, then kPhaseSharp.
const uint kBitsPerMedium = 4u;
const uint kPhaseCodes = 7u;
const uint kPhaseSharp = 8u;  // a table replaces the function where light is gathered

const uint kMultipleScatteringDirections = 64u;  // 8 zenith cosines x 8 azimuths
const uint kMultipleScatteringSteps = 20u;
const uint kTransmittanceSteps = 40u;
const uint kBendingSteps = 32u;
const uint kGroundIrradianceDirections = 64u;  // 8 zenith cosines x 8 azimuths
const uint kGroundIrradianceSize = 64u;
const uint kMaxDegree = 8u;      // of moments
const uint kMaxHarmonics = 45u;  // up to kMaxDegree
const uint kPolarisedMoments = 3u;
const uint kMaxMoments = 48u;  // of both
