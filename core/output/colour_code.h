#pragma once
// The meaning of display-encoded pixels, as the code points of ITU-T H.273 in PNGs and films.

#include <array>
#include <optional>
#include <string_view>

namespace airlight {

struct ColourCode {
  int primaries = 1;  // 1: BT.709, 9: BT.2020, 12: P3 with D65
  int transfer = 13;  // 1: BT.709 shown as by BT.1886, 13: sRGB, 16: PQ, 18: HLG

  bool operator==(const ColourCode&) const = default;
};

inline constexpr ColourCode kSrgbCode{1, 13};

// CIE xy of white, red, green and blue.
std::array<double, 8> primaries_of(const ColourCode& code);

// The exponent that takes light to code values; none where no exponent comes near.
std::optional<double> encoding_exponent(const ColourCode& code);

// The code of a display of an OpenColorIO config, found by its usual name, such as "sRGB - Display" or "Rec.2100-PQ -
// Display".
std::optional<ColourCode> colour_code_of_display(std::string_view name);

}  // namespace airlight
