#pragma once
// A long text as attributes that every reader of EXR accepts. ffmpeg fails on an unknown attribute of more than 255
// bytes, so a longer text is stored in pieces, NAME:000, NAME:001 and so on, never cut within a character.

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace airlight {

inline constexpr std::size_t kLongestAttribute = 255;

inline std::string piece_name(const std::string& name, std::size_t index) {
  char number[24];
  std::snprintf(number, sizeof number, ":%03zu", index);
  return name + number;
}

// Number of bytes from `first` on, at most `most`, that end at the end of a UTF-8 character.
inline std::size_t whole_characters(const std::string& text, std::size_t first, std::size_t most) {
  if (text.size() - first <= most) {
    return text.size() - first;
  }
  std::size_t length = most;
  while (length > most - 4 && (static_cast<unsigned char>(text[first + length]) & 0xC0U) == 0x80U) {
    --length;
  }
  return length;
}

inline std::vector<std::pair<std::string, std::string>> attributes_of(const std::string& name,
                                                                      const std::string& text) {
  if (text.size() <= kLongestAttribute) {
    return {{name, text}};
  }
  std::vector<std::pair<std::string, std::string>> pieces;
  for (std::size_t first = 0; first < text.size();) {
    const std::size_t length = whole_characters(text, first, kLongestAttribute);
    pieces.emplace_back(piece_name(name, pieces.size()), text.substr(first, length));
    first += length;
  }
  return pieces;
}

// The text of that name, whether in one attribute or in pieces; none where it does not exist. `find` returns an
// attribute's text as std::optional<std::string>.
template <class Find>
std::optional<std::string> text_in(const std::string& name, const Find& find) {
  if (std::optional<std::string> whole = find(name)) {
    return whole;
  }
  std::optional<std::string> text;
  for (std::size_t index = 0;; ++index) {
    const std::optional<std::string> piece = find(piece_name(name, index));
    if (!piece) {
      return text;
    }
    text = text.value_or("") + *piece;
  }
}

}  // namespace airlight
