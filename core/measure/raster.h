#pragma once
// A small 8-bit RGB picture that can be written on.

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/measure/colour_map.h"

namespace airlight::measure {

struct Rectangle {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

inline constexpr int kGlyphWidth = 6;  // pixels, with one of space
inline constexpr int kGlyphHeight = 7;

class Raster {
 public:
  Raster(int width, int height, Colour background);

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<std::uint8_t>& rgb() const { return rgb_; }
  Colour at(int x, int y) const;
  void set(int x, int y, Colour colour);  // no effect outside
  void fill(const Rectangle& area, Colour colour);

  // Letters of 5 x 7 dots, each `scale` pixels wide; small letters are written as capitals, unknown ones as a box.
  void write(int left, int top, int scale, Colour colour, std::string_view text);

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> rgb_;
};

int text_width(std::string_view text, int scale);

}  // namespace airlight::measure
