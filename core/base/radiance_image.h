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

// Pixels of four channels without their alpha.
template <class Value>
std::vector<Value> rgb_of(const std::vector<Value>& rgba) {
  std::vector<Value> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
  }
  return rgb;
}

}  // namespace airlight
