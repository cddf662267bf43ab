#pragma once
// The error of `orders` against path-trace that is assumed before anything is computed, by the kind of air, sun and
// camera; relative, fitted to what scripts/tolerance --fit lists.

#include <optional>

#include "core/stage/stage.h"

namespace airlight::choice {

// The error of the plain reference. Nothing is assumed among things and over a ground by maps, where the sun is far
// below the horizon, or low over thick air, or a phase function is sharper than most or peaks backward.
std::optional<double> plain_reference_error(const Stage& stage);

// The error of the method's defaults, that of the scene's wavelengths included. Something is assumed down to a sun of
// -4 degrees, over planets whose dusk is about as wide as Earth's, from places that the picture's table resolves.
std::optional<double> default_error(const Stage& stage);

}  // namespace airlight::choice
