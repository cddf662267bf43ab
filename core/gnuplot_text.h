#pragma once
// Text in gnuplot's scripts.

#include <string>
#include <string_view>

namespace airlight {

// In single quotes gnuplot takes everything as it stands but a quote, which is doubled.
inline std::string gnuplot_text(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' ? std::string("''") : std::string(1, c);
  }
  return out + "'";
}

}  // namespace airlight
