#pragma once
// Rows of a method's list of parameters under `render.*`.

#include <limits>

#include "core/scene/method_info.h"

namespace airlight::parameter {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
inline constexpr double kMostInt = std::numeric_limits<int>::max();

inline ParameterInfo whole_number(std::string_view key, double least, double most, int value,
                                  std::string_view meaning) {
  return {key, ParameterKind::integer, least, most, value, {}, meaning};
}

// 0 or above.
inline ParameterInfo number(std::string_view key, double value, std::string_view meaning) {
  return {key, ParameterKind::number, 0.0, kNoLimit, value, {}, meaning};
}

inline ParameterInfo table_size(std::string_view key, double least, double most, TableSize size,
                                std::string_view meaning) {
  return {key, ParameterKind::table_size, least, most, size, {}, meaning};
}

inline ParameterInfo choice(std::string_view key, std::span<const std::string_view> choices, std::string_view value,
                            std::string_view meaning) {
  return {key, ParameterKind::choice, 0.0, 0.0, std::string(value), choices, meaning};
}

inline ParameterInfo on_or_off(std::string_view key, bool value, std::string_view meaning) {
  return {key, ParameterKind::boolean, 0.0, 0.0, value, {}, meaning};
}

}  // namespace airlight::parameter
