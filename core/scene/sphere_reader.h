#pragma once
// `scene.spheres` of a preset.

#include <vector>

#include "core/scene/curve_reader.h"
#include "core/scene/section.h"

namespace airlight {

// `albedos`: a curve for each.
std::vector<Sphere> read_spheres(const Section& root, CurveReader& curves, std::vector<Curve>& albedos);

}  // namespace airlight
