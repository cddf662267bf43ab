#include "core/scene/air_limits.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

// The column of a density that goes in a straight line from (h0, d0) to (h1, d1), cut off at the top.
double straight_column(double h0, double d0, double h1, double d1, double top) {
  const double end = std::min(h1, top);
  if (end <= h0) {
    return 0.0;
  }
  const double d_end = d0 + (d1 - d0) * (end - h0) / (h1 - h0);
  return 0.5 * (d0 + d_end) * (end - h0);
}

double layers_column(const std::vector<DensityLayer>& layers, double top) {
  if (layers.empty()) {
    return 0.0;
  }
  double column = layers.front().density * std::min(layers.front().altitude, top);
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    const DensityLayer& a = layers[i];
    const DensityLayer& b = layers[i + 1];
    column += straight_column(a.altitude, a.density, b.altitude, b.density, top);
  }
  return column + layers.back().density * std::max(top - layers.back().altitude, 0.0);
}

// Up to altitude h, of a tent that rises from center - width.
double tent_below(const Density& d, double h) {
  const double x = std::clamp((h - d.center) / d.half_width, -1.0, 1.0);
  const double part = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
  return part * d.half_width;
}

}  // namespace

double column_km(const Density& d, double top) {
  switch (d.profile) {
    case DensityProfile::exponential:
      return -d.scale_height * std::expm1(-top / d.scale_height);
    case DensityProfile::tent:
      return tent_below(d, top) - tent_below(d, 0.0);
    case DensityProfile::lorentzian: {
      const double peak =
          d.half_width * (std::atan((top - d.center) / d.half_width) + std::atan(d.center / d.half_width));
      return std::min(peak, -d.scale_height * std::expm1(-top / d.scale_height));
    }
    case DensityProfile::constant:
      return std::min(d.below, top);
    case DensityProfile::layers:
      return layers_column(d.layers, top);
    case DensityProfile::height_fog:
      return std::min(d.below, top) - d.scale_height * std::expm1(-std::max(top - d.below, 0.0) / d.scale_height);
  }
  return 0.0;
}

double optical_depth_of(const Medium& medium, double top) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    largest = std::max(largest, medium.scattering[c] + medium.absorption[c]);
  }
  return largest * column_km(medium.density, top);
}

}  // namespace airlight
