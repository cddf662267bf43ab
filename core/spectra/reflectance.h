#pragma once
// Reflectances over the wavelength for colours of surfaces.

#include <array>

#include "core/spectra/colour.h"

namespace airlight {

// The reflectance whose colour in this sunlight is (r, g, b) times the sun's and whose slope, as the mean square over
// the fine bands, is least. It is r x the first curve + g x the second + b x the third (Burns 2015). A grey one is grey
// at all wavelengths; one of a strong colour may leave 0 to 1.
std::array<Curve, 3> reflectances_of_primaries(const Curve& sun, White white);

// That of a colour.
Curve reflectance_of(const std::array<double, 3>& colour, const Curve& sun, White white);

}  // namespace airlight
