#include "core/measure/raster.h"

#include "core/measure/glyphs.h"

namespace airlight::measure {

Raster::Raster(int width, int height, Colour background)
    : width_(width), height_(height), rgb_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  fill({0, 0, width, height}, background);
}

Colour Raster::at(int x, int y) const {
  const std::size_t place =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  return {rgb_[place], rgb_[place + 1], rgb_[place + 2]};
}

void Raster::set(int x, int y, Colour colour) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const std::size_t place =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  for (std::size_t i = 0; i < 3; ++i) rgb_[place + i] = colour[i];
}

void Raster::fill(const Rectangle& area, Colour colour) {
  for (int y = area.top; y < area.top + area.height; ++y) {
    for (int x = area.left; x < area.left + area.width; ++x) set(x, y, colour);
  }
}

void Raster::write(int left, int top, int scale, Colour colour, std::string_view text) {
  for (const char letter : text) {
    const GlyphRows& rows = glyph(letter);
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth - 1; ++column) {
        if ((rows[static_cast<std::size_t>(row)] >> (kGlyphWidth - 2 - column) & 1) == 0) continue;
        fill({left + column * scale, top + row * scale, scale, scale}, colour);
      }
    }
    left += kGlyphWidth * scale;
  }
}

int text_width(std::string_view text, int scale) {
  return kGlyphWidth * scale * static_cast<int>(text.size());
}

}  // namespace airlight::measure
