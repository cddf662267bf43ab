#include "core/scene/json_format.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/text.h"

namespace airlight {

std::string format_number(double value) {
  if (value == 0.0) {
    return std::signbit(value) ? "-0.0" : "0";
  }
  const double magnitude = std::abs(value);
  const bool plain = magnitude >= 1e-4 && magnitude < 1e6;
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 plain ? std::chars_format::fixed : std::chars_format::scientific);
  std::string text(buffer.data(), end.ptr);
  // to_chars pads the exponent to two digits and signs it: 1e+09. 1e9 is the same number and reads better.
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos) {
    const bool negative = text[exponent + 1] == '-';
    const std::size_t first_digit = text.find_first_not_of("+-0", exponent + 1);
    text = text.substr(0, exponent) + (negative ? "e-" : "e") + text.substr(first_digit);
  }
  return text;
}

std::string json_string(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (code < 0x20) {
      out += "\\u00";
      out += kHex[code >> 4U];
      out += kHex[code & 15U];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string json_choice(std::string_view word) {
  return word == "true" || word == "false" ? std::string(word) : json_string(word);
}

std::string json_list(const std::vector<double>& values) {
  return "[" + joined_of(values, format_number) + "]";
}

}  // namespace airlight
