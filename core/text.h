#pragma once
// Words and numbers as messages have them.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

namespace airlight {

// So many significant digits, in the shortest form: "0.0123", "1.5e-07", "inf".
inline std::string rounded(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

// With as many digits as tell it from any other: "6360", "0.1".
inline std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

// A share of 1: "1.25 %".
inline std::string percent(double share, int digits) {
  return rounded(100.0 * share, digits) + " %";
}

// "a, b".
template <class Words>
std::string joined(const Words& words, std::string_view separator = ", ") {
  std::string text;
  for (const auto& word : words) {
    text += (text.empty() ? std::string_view() : separator);
    text += word;
  }
  return text;
}

// ASCII letters in lower case, the rest as it is.
inline std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace airlight
