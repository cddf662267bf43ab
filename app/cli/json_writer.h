#pragma once
// Writes one JSON value piece by piece, for --json.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace airlight::cli {

class JsonWriter {
 public:
  JsonWriter& begin_object();
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& end_array();
  JsonWriter& key(std::string_view name);  // then one value

  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(double number);  // JSON knows no NaN and no infinity: those become null
  JsonWriter& value(int number) { return value(static_cast<std::int64_t>(number)); }
  JsonWriter& value(std::int64_t number);
  JsonWriter& value(std::size_t number) { return value(static_cast<std::int64_t>(number)); }
  JsonWriter& value(bool truth);
  JsonWriter& null();
  JsonWriter& raw(std::string_view json);               // a value that is JSON already
  JsonWriter& values(std::span<const double> numbers);  // a whole array

  // The text, with a line feed at its end.
  std::string take();

 private:
  void before_value();

  std::string text_;
  std::vector<bool> has_items_;  // of each open object or array
  bool after_key_ = false;
};

}  // namespace airlight::cli
