#include "core/output/colour_code.h"

#include <algorithm>
#include <string>

#include "core/base/text.h"

namespace airlight {
namespace {

// In order of preference: the first entry whose words all occur in the display's name.
struct NamedCode {
  std::array<std::string_view, 2> words;
  ColourCode code;
};
constexpr std::array<NamedCode, 9> kDisplays = {{{{"display p3", ""}, {12, 13}},
                                                 {{"p3-d65", "2084"}, {12, 16}},
                                                 {{"p3-d65", "pq"}, {12, 16}},
                                                 {{"srgb", ""}, {1, 13}},
                                                 {{"2100", "pq"}, {9, 16}},
                                                 {{"2100", "hlg"}, {9, 18}},
                                                 {{"1886", "2020"}, {9, 1}},
                                                 {{"1886", "709"}, {1, 1}},
                                                 {{"rec.709", ""}, {1, 1}}}};

}  // namespace

std::array<double, 8> primaries_of(const ColourCode& code) {
  switch (code.primaries) {
    case 9:
      return {0.3127, 0.3290, 0.708, 0.292, 0.170, 0.797, 0.131, 0.046};
    case 12:
      return {0.3127, 0.3290, 0.680, 0.320, 0.265, 0.690, 0.150, 0.060};
    default:
      return {0.3127, 0.3290, 0.64, 0.33, 0.30, 0.60, 0.15, 0.06};
  }
}

std::optional<double> encoding_exponent(const ColourCode& code) {
  switch (code.transfer) {
    case 1:
      return 1.0 / 2.4;  // BT.1886
    case 13:
      return 0.45455;  // the PNG standard's value for sRGB
    default:
      return std::nullopt;
  }
}

std::optional<ColourCode> colour_code_of_display(std::string_view name) {
  const std::string words = lower(name);
  for (const NamedCode& display : kDisplays) {
    if (std::ranges::all_of(display.words,
                            [&](std::string_view word) { return words.find(word) != std::string::npos; })) {
      return display.code;
    }
  }
  return std::nullopt;
}

}  // namespace airlight
