#pragma once
// What is known of the error of `orders` against path-trace before anything is computed, by the kind of air, sun and
// camera. Fitted to what scripts/tolerance --fit lists.

#include <optional>

#include "core/scene/scene.h"

namespace airlight::choice {

// Of every reference, however fine its tables: harmonics above the degree are missing.
double common_error(const Scene& scene);

// Of the plain reference: nothing where the sun is far below the horizon, or low over thick air. Then, and where the
// tolerance asks for better, the fine reference serves, and the distance between the two says how well it is to be
// trusted.
std::optional<double> plain_reference_error(const Scene& scene);

// Of the method's defaults: down to a sun of -4 degrees, over planets whose dusk is about as wide as Earth's, from
// places that the picture's table knows well, without terrain, spheres and a ground by maps. What a scene's wavelengths
// err is in it.
std::optional<double> default_error(const Scene& scene);

}  // namespace airlight::choice
