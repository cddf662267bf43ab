#pragma once
// Luminance of linear RGB: the Y row of the matrix from the primaries to CIE XYZ.

#include <array>
#include <span>
#include <vector>

namespace airlight::measure {

// CIE xy of red, green, blue and white, in the order of OpenEXR's `chromaticities`.
using Chromaticities = std::array<double, 8>;

// ITU-R BT.709 with D65: the meaning of an EXR without the attribute.
inline constexpr Chromaticities kBt709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

// Weights that add up to 1. Primaries on a line give those of BT.709.
std::array<double, 3> luminance_weights(const Chromaticities& chromaticities);

std::vector<float> luminance(std::span<const float> red, std::span<const float> green, std::span<const float> blue,
                             const std::array<double, 3>& weights);

}  // namespace airlight::measure
