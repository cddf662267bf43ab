#pragma once
// Two pictures and their error, small enough for a page and still linear, so that the viewer can change the exposure.

#include <cstddef>
#include <string>
#include <vector>

namespace airlight::measure {

struct ShownPictures {
  int width = 0;
  int height = 0;
  int left = 0;  // place of the stored pixels in the whole picture
  int top = 0;
  int reduced = 1;  // number of the file's pixels, across and down, that make one stored pixel
  // RGBE: three mantissas and an exponent, value = mantissa / 256 x 2^(exponent - 128); exponent 255: not finite.
  // Values below 0 are shown as 0. A reduced pixel is the mean of its pixels.
  std::vector<std::byte> a;
  std::vector<std::byte> b;
  // 0 to 254 from the scale's low to its high end, 255: not finite. A reduced pixel has the largest value of its
  // pixels.
  std::vector<std::byte> errors;
  bool logarithmic = true;
  double low = 0.0;
  double high = 0.0;
  std::string error_name;
  double exposure = 1.0;  // suits B
};

}  // namespace airlight::measure
