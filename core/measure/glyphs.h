#pragma once

#include <array>
#include <cstdint>

namespace airlight::measure {

using GlyphRows = std::array<std::uint8_t, 7>;

// Five bits a row, from the top; small letters give capitals.
const GlyphRows& glyph(char letter);

}  // namespace airlight::measure
