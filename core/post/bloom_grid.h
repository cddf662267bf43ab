#pragma once
// The size of the bloom's finest grid, which it is made on and gathered into.

#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

Extent bloom_grid(const Scene& scene);

}  // namespace airlight
