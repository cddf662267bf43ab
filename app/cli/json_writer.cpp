#include "app/cli/json_writer.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace airlight::cli {

JsonWriter& JsonWriter::open(char bracket) {
  raw(std::string_view(&bracket, 1));
  has_items_.push_back(false);
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  assert(!has_items_.empty());
  has_items_.pop_back();
  text_ += bracket;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  raw(json_string(name) + ":");
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  return raw(std::isfinite(number) ? format_number(number) : "null");
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  if (after_key_) {
    after_key_ = false;
  } else if (!has_items_.empty()) {
    text_ += has_items_.back() ? "," : "";
    has_items_.back() = true;
  }
  text_ += json;
  return *this;
}

std::string JsonWriter::take() {
  assert(has_items_.empty() && !after_key_);
  return std::exchange(text_, {}) + "\n";
}

}  // namespace airlight::cli
