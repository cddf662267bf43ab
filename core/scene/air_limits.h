#pragma once
// What air is too thick to be any scene's: refused by its quantity, before 32 bits run out of digits over it.

#include "core/scene/scene.h"

namespace airlight {

// Vertical optical depth of one medium that a preset may ask for: light is gone after 100; a cloud has a thousand.
inline constexpr double kMostOpticalDepth = 1e6;

// Column of a density between the ground and `top`, km; of a `lorentzian` an upper bound.
double column_km(const Density& density, double top);

// Vertical optical depth of the medium in the channel where it is largest.
double optical_depth_of(const Medium& medium, double top);

}  // namespace airlight
