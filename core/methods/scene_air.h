#pragma once
// A scene's air with the options of its method.

#include "core/air/air.h"
#include "core/air/scene_block.h"
#include "core/scene/scene.h"

namespace airlight {

// The options that the method's own keys set; a missing key sets none.
AirOptions air_options(const RenderSettings& settings);

// The last few airs are remembered, so that frames, qualities and tiles of the same air share it.
Air air_of(const Scene& scene);

// formulas_of() the scene's air.
physics::Physics make_physics(const Scene& scene);

}  // namespace airlight
