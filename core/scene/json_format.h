#pragma once
// Numbers and strings as JSON text: the writing half of the preset, and how messages quote a value.

#include <string>
#include <string_view>
#include <vector>

namespace airlight {

// The shortest text that reads back as the same double: 0.0001, 1280, 1e9, 8.5e-5. The number must be finite.
std::string format_number(double value);

// The text in quotes, escaped.
std::string json_string(std::string_view text);

// One of several words as a preset has it: true and false without quotes.
std::string json_choice(std::string_view word);

// "[1, 2.5]".
std::string json_list(const std::vector<double>& values);

}  // namespace airlight
