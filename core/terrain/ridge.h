#pragma once
// A seeded mountain range.

#include <vector>

#include "core/scene/scene.h"

namespace airlight {

inline constexpr int kRidgeColumns = 1024;
inline constexpr int kRidgeRows = 512;

// Heights in km, row by row, 0 at the edges; the highest is as high as the ridge says.
std::vector<double> ridge_heights(const Ridge& ridge);

}  // namespace airlight
