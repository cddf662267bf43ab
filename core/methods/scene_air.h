#pragma once
// A scene's air as its method wants it.

#include "core/air/air.h"
#include "core/air/scene_block.h"
#include "core/scene/scene.h"

namespace airlight {

// What the method's own keys say of the air; a key that is not there says nothing.
AirOptions air_options(const RenderSettings& settings);

// The last few airs are remembered: all frames, qualities and tiles of one air find it made.
Air air_of(const Scene& scene);

// formulas_of() its air.
physics::Physics make_physics(const Scene& scene);

}  // namespace airlight
