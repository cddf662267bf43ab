#include "core/scene/problems.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/printable.h"

namespace airlight {

void Problems::add(const PresetValue& at, std::string_view own_pointer, std::string_view message) {
  const std::optional<std::string> told = told_ ? told_(own_pointer) : std::string(own_pointer);
  if (!told) {
    return;
  }
  const std::string& pointer = *told;
  std::string text = printable(at.source);
  if (at.line > 0) {
    text += ":" + std::to_string(at.line);
  }
  text += ": ";
  if (!pointer.empty()) {
    text += shown_pointer(pointer) + ": ";
  }
  problems_.push_back({.source = at.source, .line = at.line, .text = text + printable(message)});
}

void Problems::throw_if_any() {
  if (problems_.empty()) {
    return;
  }
  std::ranges::stable_sort(problems_, [](const Problem& a, const Problem& b) {
    return a.source != b.source ? a.source < b.source : a.line < b.line;
  });
  const std::size_t told = std::min(problems_.size(), kMostProblems);
  const auto text_of = [](const Problem& p) { return p.text; };
  std::string text = joined_of(std::span(problems_).first(told), text_of, "\n");
  if (problems_.size() > told) {
    const std::size_t more = problems_.size() - told;
    text += "\n" + printable(problems_[told].source) + ": " + std::to_string(more) +
            (more == 1 ? " problem more" : " problems more");
  }
  throw InputError::of_lines(text);
}

std::string shown_pointer(std::string_view pointer) {
  return printable(shortened(pointer));
}

std::string quoted(const PresetValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) {
    return format_number(*number);
  }
  if (const auto* text = std::get_if<std::string>(&value.data)) {
    return quoted_text(*text);
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
