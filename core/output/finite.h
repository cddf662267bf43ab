#pragma once
// What is written must be numbers: one check for all that leaves the program.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace airlight {

// "the table moments holds 3 values that are not finite, the first at column 2, row 0"; empty: all are finite.
// `values`: rows from the top, `width` pixels of `channels` values each.
inline std::string finite_fault(std::string_view what, std::span<const float> values, std::size_t width,
                                std::size_t channels) {
  const auto is_bad = [](float value) { return !std::isfinite(value); };
  const auto first = std::ranges::find_if(values, is_bad);
  if (first == values.end()) {
    return {};
  }
  const std::size_t pixel = static_cast<std::size_t>(first - values.begin()) / channels;
  return std::string(what) + " holds " + std::to_string(std::ranges::count_if(values, is_bad)) +
         " values that are not finite, the first at column " + std::to_string(pixel % width) + ", row " +
         std::to_string(pixel / width);
}

}  // namespace airlight
