#include "core/scene/problems.h"

#include <algorithm>

#include "core/error.h"
#include "core/scene/json_format.h"

namespace airlight {
namespace {

// Enough to recognise a text by, short enough for one line.
constexpr std::size_t kLongestQuote = 60;

std::string shortened(std::string_view text) {
  if (text.size() <= kLongestQuote) {
    return json_string(text);
  }
  std::size_t end = kLongestQuote;
  // Not inside a UTF-8 character: its later bytes are 10xxxxxx.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  return json_string(std::string(text.substr(0, end)) + "...");
}

}  // namespace

void Problems::add(const PresetValue& at, std::string_view pointer, std::string_view message) {
  std::string text = at.source;
  if (at.line > 0) {
    text += ":" + std::to_string(at.line);
  }
  text += ": ";
  if (!pointer.empty()) {
    text += std::string(pointer) + ": ";
  }
  problems_.push_back({.source = at.source, .line = at.line, .text = text + std::string(message)});
}

void Problems::throw_if_any() {
  if (problems_.empty()) {
    return;
  }
  std::ranges::stable_sort(problems_, [](const Problem& a, const Problem& b) {
    return a.source != b.source ? a.source < b.source : a.line < b.line;
  });
  std::string text;
  for (const Problem& problem : problems_) {
    text += (text.empty() ? "" : "\n") + problem.text;
  }
  throw InputError(text);
}

std::string quoted(const PresetValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) {
    return format_number(*number);
  }
  if (const auto* text = std::get_if<std::string>(&value.data)) {
    return shortened(*text);
  }
  if (const auto* boolean = std::get_if<bool>(&value.data)) {
    return *boolean ? "true" : "false";
  }
  if (const auto* array = std::get_if<PresetArray>(&value.data)) {
    return "an array of " + std::to_string(array->size());
  }
  return std::holds_alternative<PresetObject>(value.data) ? "an object" : "null";
}

}  // namespace airlight
