#pragma once
// Colours for errors.

#include <array>
#include <cstdint>

namespace airlight::measure {

using Colour = std::array<std::uint8_t, 3>;  // sRGB

inline constexpr Colour kNotANumber = {255, 0, 255};  // outside the map: NaN, infinity

// 0 to 1 -> dark violet to yellow. Equal steps look equal: lightness grows evenly, also in grey and for the
// colour-blind.
Colour error_colour(double fraction);

// Scene-linear, already exposed -> sRGB with a soft shoulder, for a look at a picture beside its error.
std::uint8_t display_code(double exposed);

// CIE L* of an sRGB colour, 0 to 100.
double lightness(const Colour& colour);

}  // namespace airlight::measure
