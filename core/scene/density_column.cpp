#include "core/scene/density_column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/physics/physics.h"

namespace airlight {
namespace {

// The column of a density that is linear from (h0, d0) to (h1, d1), cut off at the top.
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

// The column up to altitude h of a tent that rises from center - half_width.
double tent_below(const Density& d, double h) {
  const double x = std::clamp((h - d.center) / d.half_width, -1.0, 1.0);
  const double part = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
  return part * d.half_width;
}

// By Gauss and Legendre's two points, in pieces of at most a quarter of a scale.
double lorentzian_column(const Density& d, double top) {
  physics::Physics formulas;
  physics::MediumData medium{};
  medium.scale_height = d.scale_height;
  medium.center = d.center;
  medium.half_width = d.half_width;
  const double scale = std::min({top / 8.0, 0.25 * d.scale_height, 0.25 * d.half_width});
  std::array<double, 5> edges{0.0, top, d.center - d.half_width, d.center, d.center + d.half_width};
  std::ranges::sort(edges);
  double sum = 0.0;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double low = std::clamp(edges[k - 1], 0.0, top);
    const double high = std::clamp(edges[k], 0.0, top);
    const int pieces = static_cast<int>(std::clamp((high - low) / scale + 1.0, 1.0, 1000.0));
    const double width = (high - low) / pieces;
    for (int i = 0; i < pieces && width > 0.0; ++i) {
      const double middle = low + (i + 0.5) * width;
      const double away = 0.28867513459481287 * width;
      sum += 0.5 * width *
             (formulas.density(physics::kDensityLorentzian, medium, middle - away) +
              formulas.density(physics::kDensityLorentzian, medium, middle + away));
    }
  }
  return sum;
}

}  // namespace

double density_column(const Density& density, double top) {
  return density.profile == DensityProfile::lorentzian ? lorentzian_column(density, top) : column_km(density, top);
}

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
