#pragma once
// "Did you mean": the nearest known name to a misspelt one.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace airlight {

// The candidate with the fewest typing slips (letters added, lost, changed or swapped), or one that contains the name;
// none when all are far.
std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace airlight
