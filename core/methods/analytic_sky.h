#pragma once
// The inputs of the closed-form skies beside the scene (shaders/shared/analytic.h), by quadrature in double.

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"
#include "core/stage/stage.h"

namespace airlight {

// The scene's physics with its AnalyticData filled in.
physics::Physics make_analytic_physics(const Part& part);

// The same data in float, as the shader reads it.
std::vector<std::byte> analytic_bytes(const physics::AnalyticData& data);

}  // namespace airlight
