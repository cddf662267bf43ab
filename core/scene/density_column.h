#pragma once
// The amount of a medium above the ground. Media too thick for any scene are refused by this amount, before 32 bits run
// out of digits.

#include "core/scene/scene.h"

namespace airlight {

// Greatest vertical optical depth of one medium in a preset. Light is gone after 100; a cloud has a thousand.
inline constexpr double kMostOpticalDepth = 1e6;

// The density's integral along the vertical from the ground to `top`, km.
double density_column(const Density& density, double top);

// The integral in closed form; for a `lorentzian` an upper bound.
double column_km(const Density& density, double top);

// Vertical optical depth of the medium in the channel with the largest, or an upper bound on it.
double optical_depth_of(const Medium& medium, double top);

}  // namespace airlight
