#pragma once
// Writes one JSON value piece by piece, for --json.

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/json_format.h"

namespace airlight::cli {

class JsonWriter {
 public:
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& key(std::string_view name);  // one value must follow

  JsonWriter& value(std::string_view text) { return raw(json_string(text)); }
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(double number);  // JSON knows no NaN and no infinity: those become null
  JsonWriter& value(bool truth) { return raw(truth ? "true" : "false"); }
  template <std::integral Whole>
  JsonWriter& value(Whole number) {
    return raw(std::to_string(number));
  }
  template <class T>
  JsonWriter& value(const std::optional<T>& perhaps) {
    return perhaps ? value(*perhaps) : null();
  }
  JsonWriter& text_or_null(std::string_view text) { return text.empty() ? null() : value(text); }
  JsonWriter& null() { return raw("null"); }
  JsonWriter& raw(std::string_view json);  // a value in JSON
  // Writes a whole array.
  template <class Values>
  JsonWriter& values(const Values& all) {
    begin_array();
    for (const auto& one : all) {
      value(one);
    }
    return end_array();
  }

  // The text, ending with a line feed.
  std::string take();

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);

  std::string text_;
  std::vector<bool> has_items_;  // of each open object or array
  bool after_key_ = false;
};

}  // namespace airlight::cli
