// What the passes over a cloud's cells share: x fastest, then y, then z.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define UNROLL [[unroll]]
#define real float
#include "shared/cloud.h"


#include "physics/segment.glsl"
#include "physics/cloud_light.glsl"

// A column that may lie beyond the edge once, on the grid that repeats itself.
uint repeated(uint i, uint count) { return i >= count ? i - count : i; }
