#pragma once
// The order in which an EXR's channels are listed.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>

namespace airlight {

// "bloom" of "bloom.R": what stands before the last dot; empty where there is none.
inline std::string layer_of(const std::string& full_name) {
  const std::size_t dot = full_name.rfind('.');
  return dot == std::string::npos ? "" : full_name.substr(0, dot);
}

// "R" of "bloom.R".
inline std::string name_in_layer(const std::string& full_name) {
  return full_name.substr(full_name.rfind('.') + 1);
}

// Channels are listed by layer, in it the colours first, then alpha and depth, then the others by name.
inline bool is_listed_before(const std::string& a, const std::string& b) {
  constexpr std::array<std::string_view, 5> kFirst = {"R", "G", "B", "A", "Z"};
  const auto place = [&](const std::string& full_name) {
    const std::string name = name_in_layer(full_name);
    const auto found = std::ranges::find(kFirst, std::string_view(name));
    return std::tuple(layer_of(full_name), found - kFirst.begin(), name);
  };
  return place(a) < place(b);
}

}  // namespace airlight
