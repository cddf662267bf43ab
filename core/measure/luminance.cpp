#include "core/measure/luminance.h"

#include <cmath>
#include <cstddef>

#include "core/base/huge_pages.h"

namespace airlight::measure {

// White's chromaticity is the mean of the primaries' chromaticities, weighted by S = X + Y + Z. Since Y = y S, each
// weight is the white point's barycentric coordinate in the triangle of primaries times y / y_white.
std::array<double, 3> luminance_weights(const Chromaticities& c) {
  const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
  const double white_x = c[6];
  const double white_y = c[7];
  // Twice the triangle's area, and the coordinates as ratios to it.
  const double whole = cross(c[2] - c[0], c[3] - c[1], c[4] - c[0], c[5] - c[1]);
  const double green = cross(white_x - c[0], white_y - c[1], c[4] - c[0], c[5] - c[1]) / whole;
  const double blue = cross(c[2] - c[0], c[3] - c[1], white_x - c[0], white_y - c[1]) / whole;
  const double red = 1.0 - green - blue;
  const std::array<double, 3> weights = {red * c[1] / white_y, green * c[3] / white_y, blue * c[5] / white_y};
  for (const double weight : weights) {
    if (!std::isfinite(weight)) return luminance_weights(kBt709);
  }
  return weights;
}

std::vector<float> luminance(std::span<const float> red, std::span<const float> green, std::span<const float> blue,
                             const std::array<double, 3>& weights) {
  std::vector<float> result = large_vector<float>(red.size());
  for (std::size_t i = 0; i < red.size(); ++i) {
    result[i] =
        static_cast<float>(weights[0] * static_cast<double>(red[i]) + weights[1] * static_cast<double>(green[i]) +
                           weights[2] * static_cast<double>(blue[i]));
  }
  return result;
}

}  // namespace airlight::measure
