#pragma once
// Text in gnuplot's scripts.

#include <string>
#include <string_view>

namespace airlight {

// Within single quotes gnuplot takes every character as it stands, except a single quote, which must be doubled.
inline std::string gnuplot_text(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' ? std::string("''") : std::string(1, c);
  }
  return out + "'";
}

}  // namespace airlight
