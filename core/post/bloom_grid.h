#pragma once
// The size of the bloom's finest grid, on which bloom is computed and into which bands are gathered.

#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

Extent bloom_grid(const Scene& scene);

}  // namespace airlight
