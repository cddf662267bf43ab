#pragma once
// Degrees stand in presets and messages, radians in the scene.

#include <numbers>

namespace airlight {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // in radians

double radians_from_degrees(double degrees);

// The shortest decimal number of degrees that radians_from_degrees() turns into exactly these radians. Every angle of a
// resolved scene comes from degrees and has one. For any other value it is the nearest, within one ulp of the radians.
double degrees_from_radians(double radians);

}  // namespace airlight
