#pragma once
// "Did you mean" for commands, options and their values.

#include <string>
#include <string_view>
#include <vector>

namespace airlight::cli {

// " (did you mean 'NAME'?)", or nothing when no name is near. Names of one letter, "-o", are never near: a slip turns
// any of them into any other.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace airlight::cli
