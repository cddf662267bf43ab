#pragma once
// A picture on the host: scene-linear radiance, W/(m2 sr) for a sun irradiance in W/m2.

#include <cstddef>
#include <vector>

namespace airlight {

struct RadianceImage {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;  // row by row from the top, four floats a pixel; alpha 0 outside a fisheye's circle

  const float* at(int x, int y) const {
    return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  }
};

}  // namespace airlight
