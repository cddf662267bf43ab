#pragma once
// The transfer function of sRGB, IEC 61966-2-1, and luminance of the primaries that it shares with ITU-R BT.709.

#include <cmath>

namespace airlight {

// sRGB's curve from 0 to 1 into 0 to 1, and its inverse. Outside it continues, below as a line, above as the power.
template <class Real>
Real srgb_encoded(Real linear) {
  return linear <= Real(0.0031308) ? Real(12.92) * linear : Real(1.055) * std::pow(linear, 1 / Real(2.4)) - Real(0.055);
}

template <class Real>
Real srgb_decoded(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92) : std::pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

// The luminance of linear channels, ITU-R BT.709-6 item 3.2, in their unit.
constexpr double bt709_luminance(double red, double green, double blue) {
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

}  // namespace airlight
