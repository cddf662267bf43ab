#pragma once
// The formulas of clouds (shaders/physics/cloud_*.glsl) on double, apart from those of the air, which need none of
// them.

#include "core/physics/device_scene.h"
#include "core/physics/physics.h"

namespace airlight {

namespace physics {

#include "shaders/shared/cloud.h"

// Apart, as a field's grid needs no more.
struct CloudEdgePhysics {
#include "shaders/physics/cloud_edge.glsl"
};

#define UNROLL  // a mark for the shaders' compiler
struct CloudPhysics : Physics {
#include "shaders/physics/cloud_air.glsl"
#include "shaders/physics/cloud_harmonics.glsl"
#include "shaders/physics/cloud_light.glsl"
#include "shaders/physics/cloud_march.glsl"
#include "shaders/physics/cloud_sun.glsl"
};
#undef UNROLL

}  // namespace physics

// The buffers in the device's layout.
namespace device {

#include "shaders/shared/cloud.h"

}  // namespace device

}  // namespace airlight
