#pragma once
// How much of a medium stands above the ground, and what is too thick to be any scene's: that is refused by its
// quantity, before 32 bits run out of digits over it.

#include "core/scene/scene.h"

namespace airlight {

// Vertical optical depth of one medium that a preset may ask for: light is gone after 100; a cloud has a thousand.
inline constexpr double kMostOpticalDepth = 1e6;

// The density's integral straight up from the ground to `top`, km.
double density_column(const Density& density, double top);

// The same in closed form; of a `lorentzian` an upper bound.
double column_km(const Density& density, double top);

// Vertical optical depth of the medium in the channel where it is largest, or a bound on it.
double optical_depth_of(const Medium& medium, double top);

}  // namespace airlight
