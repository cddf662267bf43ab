#pragma once
// Text of others (keys, values, names of files, attributes) as a message may show it: no character that a terminal
// obeys, and never more than fits a line.

#include <cstddef>
#include <string>
#include <string_view>

namespace airlight {

inline constexpr std::size_t kLongestQuote = 80;  // bytes of any input in a message
inline constexpr std::size_t kMostProblems = 20;  // of one preset; the rest is counted

// A character of UTF-8: its code and how many bytes it takes; no bytes where there is none.
struct Character {
  unsigned code = 0;
  std::size_t bytes = 0;
};
Character character_at(std::string_view text, std::size_t i);

// Control characters (of ASCII and Latin-1, of writing direction, the separators of lines) as \n, \t, \u001b, and bytes
// that are no UTF-8 as \xff. A line break stays where `keep_lines` says so.
std::string printable(std::string_view text, bool keep_lines = false);

// At most `most` bytes of it, whole characters, "..." at the end where it was longer.
std::string shortened(std::string_view text, std::size_t most = kLongestQuote);

// In quotes: "tall", shortened and printable.
std::string quoted_text(std::string_view text);

}  // namespace airlight
