#pragma once
// JSON text -> PresetValue, each value with its line. Only json_text.cpp includes the JSON library.

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/preset.h"

namespace airlight {

// `//` comments are accepted. Throws InputError with line and column: not JSON, a duplicate key, a number too large for
// a double, nesting beyond kMaxNesting.
PresetValue parse_json_text(std::string_view text, std::string_view source);

// The value of one option, without lines; none when the text is not JSON at all.
std::optional<PresetValue> try_parse_json_value(std::string_view text, std::string_view source);

// "/a~1b/0" from its parts: the pointer of one key below another, escaped by RFC 6901.
std::string pointer_below(std::string_view parent, std::string_view key);

inline constexpr int kMaxNesting = 64;

}  // namespace airlight
