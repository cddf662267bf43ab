#pragma once
// How much of a medium stands above the ground.

#include "core/scene/scene.h"

namespace airlight {

// The density's integral straight up from the ground to `top`, km.
double density_column(const Density& density, double top);

}  // namespace airlight
