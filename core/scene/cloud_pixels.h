#pragma once
// Fields of clouds too fine for a picture.

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace airlight {

// Width that one of the picture's pixels sees at this distance, km, in its middle: of a map, at its equator.
double pixel_width(const Camera& camera, const ImageSize& image, double distance);

// A line for each field below the camera whose clouds are less than two pixels apart where they are nearest: one ray a
// pixel then makes patterns that the field does not have.
std::vector<std::string> cloud_warnings(const Scene& scene);

}  // namespace airlight
