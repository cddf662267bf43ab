#pragma once
// Foreign text (keys, values, names of files, attributes) made fit for a message: without characters that control a
// terminal, and short enough for a line.

#include <cstddef>
#include <string>
#include <string_view>

namespace airlight {

inline constexpr std::size_t kLongestQuote = 80;  // bytes of any input in a message
inline constexpr std::size_t kMostProblems = 20;  // of one preset; the rest is counted

// A character of UTF-8: its code and its number of bytes, 0 where there is none.
struct Character {
  unsigned code = 0;
  std::size_t bytes = 0;
};
Character character_at(std::string_view text, std::size_t i);

// Shows control characters (of ASCII and Latin-1, of writing direction, line separators) as \n, \t, \u001b, and bytes
// that are not UTF-8 as \xff. With `keep_lines` a line break stays.
std::string printable(std::string_view text, bool keep_lines = false);

// At most `most` bytes of the text, whole characters, with "..." at the end where it was longer.
std::string shortened(std::string_view text, std::size_t most = kLongestQuote);

// The text in quotes, shortened and printable: "tall".
std::string quoted_text(std::string_view text);

}  // namespace airlight
