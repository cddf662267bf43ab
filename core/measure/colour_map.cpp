#include "core/measure/colour_map.h"

#include <algorithm>
#include <cmath>

#include "core/base/srgb.h"

namespace airlight::measure {
namespace {

// Anchors of the viridis map (Smith and van der Walt 2015, released as CC0) at ninths.
constexpr std::array<Colour, 10> kAnchors = {{{68, 1, 84},
                                              {72, 40, 120},
                                              {62, 73, 137},
                                              {49, 104, 142},
                                              {38, 130, 142},
                                              {31, 158, 137},
                                              {53, 183, 121},
                                              {110, 206, 88},
                                              {181, 222, 43},
                                              {253, 231, 37}}};

double linear_from_code(std::uint8_t code) {
  return srgb_decoded(static_cast<double>(code) / 255.0);
}

}  // namespace

Colour error_colour(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(kAnchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
  const double share = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = static_cast<double>(kAnchors[below][i]);
    const double high = static_cast<double>(kAnchors[below + 1][i]);
    colour[i] = static_cast<std::uint8_t>(std::lround(low + share * (high - low)));
  }
  return colour;
}

std::uint8_t display_code(double exposed) {
  const double shown = 1.0 - std::exp(-std::max(exposed, 0.0));
  const double encoded = srgb_encoded(shown);
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(encoded, 0.0, 1.0)));
}

double lightness(const Colour& colour) {
  const double luminance =
      bt709_luminance(linear_from_code(colour[0]), linear_from_code(colour[1]), linear_from_code(colour[2]));
  return luminance > 0.008856 ? 116.0 * std::cbrt(luminance) - 16.0 : 903.3 * luminance;
}

}  // namespace airlight::measure
