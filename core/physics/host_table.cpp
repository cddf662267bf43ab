#include <algorithm>
#include <cmath>
#include <limits>

#include "core/physics/physics.h"

namespace airlight::physics {

vec3 HostTable::fetch(real u, real v) const {
  if (std::isnan(u) || std::isnan(v)) {  // from a table that held one; as an index it would be anywhere
    return vec3(std::numeric_limits<real>::quiet_NaN());
  }
  const real x = clamp(u * width - 0.5, 0.0, width - 1.0);
  const real y = clamp(v * height - 0.5, 0.0, height - 1.0);
  const int i = std::min(static_cast<int>(x), std::max(width - 2, 0));
  const int j = std::min(static_cast<int>(y), std::max(height - 2, 0));
  const real fx = x - i;
  const real fy = y - j;
  const auto texel = [&](int column, int row) {
    return texels[static_cast<std::size_t>(std::min(row, height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::min(column, width - 1))];
  };
  return (texel(i, j) * (1.0 - fx) + texel(i + 1, j) * fx) * (1.0 - fy) +
         (texel(i, j + 1) * (1.0 - fx) + texel(i + 1, j + 1) * fx) * fy;
}

vec3 HostTable::fetch_unit(real x, real y) const {
  return fetch((0.5 + x * (width - 1)) / width, (0.5 + y * (height - 1)) / height);
}

}  // namespace airlight::physics
