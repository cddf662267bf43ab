#pragma once
// Words and numbers in the form that messages use.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace airlight {

// The number with so many significant digits, in the shortest form: "0.0123", "1.5e-07", "inf".
inline std::string rounded(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

// The number with the fewest digits that tell it from any other: "6360", "0.1".
template <std::floating_point Number>
std::string shortest(Number value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

// A share of 1: "1.25 %".
inline std::string percent(double share, int digits) {
  return rounded(100.0 * share, digits) + " %";
}

// The number that the whole text is, if finite.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number value{};
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  return whole && std::isfinite(static_cast<double>(value)) ? std::optional(value) : std::nullopt;
}

// The pieces between the separators: one more than there are separators.
inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size(); start += parts.back().size() + 1) {
    parts.emplace_back(text.substr(start, text.find(separator, start) - start));
  }
  return parts;
}

// "1:2.5:3".
inline std::optional<std::array<double, 3>> three_numbers(std::string_view text) {
  std::array<double, 3> numbers{};
  const std::vector<std::string> parts = split(text, ':');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<double> number = parts.size() == numbers.size() ? number_from<double>(parts[i]) : std::nullopt;
    if (!number) {
      return std::nullopt;
    }
    numbers[i] = *number;
  }
  return numbers;
}

// "a, b".
template <class Words>
std::string joined(const Words& words, std::string_view separator = ", ") {
  std::string text;
  for (const auto& word : words) {
    text += (text.empty() ? std::string_view() : separator);
    text += word;
  }
  return text;
}

// The words of the items, joined; empty words are skipped.
template <class Items, class WordOf>
std::string joined_of(const Items& items, WordOf word_of, std::string_view separator = ", ") {
  std::vector<std::string> words;
  for (const auto& item : items) {
    words.emplace_back(word_of(item));
  }
  std::erase(words, "");
  return joined(words, separator);
}

// The enumerator of that name; `names` are in the order of the enumerators.
template <class Enum, class Names>
std::optional<Enum> named(const Names& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == std::ranges::end(names) ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

// ASCII letters in lower case, the rest as it is.
inline std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// Text of several lines, such as libraries write, as one line.
inline std::string one_line(std::string text) {
  text.erase(text.find_last_not_of("\n ") + 1);
  const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  std::ranges::replace_if(text, ends_line, ' ');
  return text;
}

}  // namespace airlight
