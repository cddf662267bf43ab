#include "core/scene/json_text.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/scene/printable.h"
#include "core/scene/problems.h"

namespace airlight {
namespace {

using Json = nlohmann::json;

// Lines and columns count from 1.
struct Place {
  int line = 1;
  int column = 1;
};

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t last_break = before.rfind('\n');
  const std::size_t line_start = last_break == std::string_view::npos ? 0 : last_break + 1;
  return {.line = 1 + static_cast<int>(std::ranges::count(before, '\n')),
          .column = 1 + static_cast<int>(before.size() - line_start)};
}

// Reads the text for the parser and keeps the line of the last character that the parser took. The parser looks one
// character beyond a number, so a line break counts only once a character after it was taken.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  int* line = nullptr;
  bool after_break = false;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    if (line != nullptr && after_break) {
      ++*line;
    }
    after_break = *at == '\n';
    ++at;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

// The part after the place in "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while
// ...".
std::string library_reason(std::string_view what) {
  const std::size_t column = what.find("column ");
  const std::size_t colon = column == std::string_view::npos ? column : what.find(": ", column);
  std::string reason(colon == std::string_view::npos ? what : what.substr(colon + 2));
  std::ranges::replace(reason, '\n', ' ');
  // The library quotes all that it last read, even if that is the rest of the file.
  constexpr std::string_view kQuote = "last read: '";
  const std::size_t quote = reason.find(kQuote);
  const std::size_t end = reason.rfind('\'');
  if (quote != std::string::npos && end >= quote + kQuote.size()) {
    const std::size_t start = quote + kQuote.size();
    reason.replace(start, end - start, shortened(std::string_view(reason).substr(start, end - start)));
  }
  return printable(reason);
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' || c == '-';
}

// The library tells the number of characters that it had read; an editor needs the start of the offending word.
std::size_t token_start(std::string_view text, std::size_t read, std::string_view reason) {
  if (read == 0 || read > text.size()) {
    return text.size();
  }
  std::size_t start = read - 1;
  if (reason.find("unexpected string literal") != std::string_view::npos && start > 0) {
    do {
      start = text.rfind('"', start - 1);
    } while (start != std::string_view::npos && start > 0 && text[start - 1] == '\\');
    return std::min(start, read - 1);
  }
  if (reason.find("invalid literal") != std::string_view::npos && start > 0 && !is_word(text[start]) &&
      is_word(text[start - 1])) {
    --start;  // the character that ended the word
  }
  while (start > 0 && is_word(text[start]) && is_word(text[start - 1])) {
    --start;
  }
  return start;
}

// Builds the tree from the parser's events. The stack holds pointers into the tree. A container's elements move only
// when a sibling is added, and at that moment no deeper frame is open.
class TreeBuilder {
 public:
  // `lines` is false for an option's value, whose lines need not be named.
  TreeBuilder(std::string_view text, std::string_view source, bool lines, int& line)
      : text_(text), source_(source), lines_(lines), line_(line) {}

  PresetValue take_root() { return std::move(root_); }
  const std::string& problem() const { return problem_; }
  bool is_json() const { return is_json_; }  // false: the text is not JSON

  bool null() { return leaf(std::monostate{}); }
  bool boolean(bool value) { return leaf(value); }
  bool number_integer(Json::number_integer_t value) { return leaf(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return leaf(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) { return leaf(value); }
  bool string(std::string& value) { return leaf(value); }
  bool binary(Json::binary_t&) { return fail("binary data is not part of a preset"); }
  bool start_object(std::size_t) { return open(PresetObject{}); }
  bool start_array(std::size_t) { return open(PresetArray{}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Frame& frame = stack_.back();
    frame.key = name;
    frame.key_line = line_;
    const auto& object = std::get<PresetObject>(frame.value->data);
    const auto earlier = object.find(name);
    if (earlier != object.end()) {
      std::string reason = "duplicate key";
      if (lines_) {
        reason.append("; the first stands on line ").append(std::to_string(earlier->second.line));
      }
      return fail(reason + "; keep one of them");
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const Json::exception& error) {
    if (error.id == 406) {
      return fail(shortened(last_token) + " is too large for a number; expected at most 1.8e308 in magnitude");
    }
    const std::string reason = library_reason(error.what());
    const Place place = place_of(text_, token_start(text_, position, reason));
    is_json_ = false;
    problem_ =
        source_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": not JSON: " + reason;
    return false;
  }

 private:
  struct Frame {
    PresetValue* value = nullptr;
    std::string key;   // the pending key of an object
    int key_line = 0;  // where it stands
  };

  PresetValue* add(PresetValue value) {
    value.source = source_;
    value.line = lines_ ? line_ : 0;
    if (stack_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Frame& frame = stack_.back();
    if (auto* array = std::get_if<PresetArray>(&frame.value->data)) {
      return &array->emplace_back(std::move(value));
    }
    value.line = lines_ ? frame.key_line : 0;
    return &(std::get<PresetObject>(frame.value->data)[frame.key] = std::move(value));
  }

  template <class T>
  bool leaf(T data) {
    PresetValue value;
    value.data = std::move(data);
    add(std::move(value));
    return true;
  }

  template <class T>
  bool open(T container) {
    if (stack_.size() >= kMaxNesting) {
      return fail("nested deeper than " + std::to_string(kMaxNesting) + " levels; a preset needs 6");
    }
    PresetValue value;
    value.data = std::move(container);
    stack_.push_back({.value = add(std::move(value)), .key = {}, .key_line = 0});
    return true;
  }

  bool close() {
    stack_.pop_back();
    return true;
  }

  bool fail(std::string_view reason) {
    std::string pointer;
    for (const Frame& frame : stack_) {
      const auto* array = std::get_if<PresetArray>(&frame.value->data);
      // In an array the failing value is the next one, unless a deeper frame already holds it.
      const bool innermost = &frame == &stack_.back();
      pointer =
          pointer_below(pointer, array == nullptr ? frame.key : std::to_string(array->size() - (innermost ? 0U : 1U)));
    }
    problem_ = source_;
    if (lines_) {
      problem_.append(":").append(std::to_string(line_));
    }
    problem_.append(": ");
    if (!pointer.empty()) {
      problem_.append(shown_pointer(pointer)).append(": ");
    }
    problem_.append(reason);
    return false;
  }

  std::string_view text_;
  std::string source_;
  bool lines_;
  int& line_;
  bool is_json_ = true;
  PresetValue root_;
  std::vector<Frame> stack_;
  std::string problem_;
};

bool run(std::string_view text, TreeBuilder& builder, int& line) {
  const CountingIterator first{.at = text.data(), .line = &line};
  const CountingIterator last{.at = text.data() + text.size()};
  return Json::sax_parse(first, last, &builder, nlohmann::json::input_format_t::json, true, true);
}

}  // namespace

std::string pointer_below(std::string_view parent, std::string_view key) {
  std::string pointer(parent);
  pointer += '/';
  for (const char c : key) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      pointer += c;
    }
  }
  return pointer;
}

PresetValue parse_json_text(std::string_view text, std::string_view source) {
  // The library takes a zero byte for the end of the text and would ignore what follows.
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    const Place place = place_of(text, zero);
    throw InputError(std::string(source) + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                     ": not JSON: a zero byte; expected text");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(std::string(source) +
                     ": empty; expected a JSON object, e.g. {\"airlight\": 1, \"extends\": " + "\"earth\"}");
  }
  int line = 1;
  TreeBuilder builder(text, source, true, line);
  if (!run(text, builder, line)) {
    throw InputError(builder.problem());
  }
  return builder.take_root();
}

std::optional<PresetValue> try_parse_json_value(std::string_view text, std::string_view source) {
  int line = 1;
  TreeBuilder builder(text, source, false, line);
  if (run(text, builder, line)) {
    return builder.take_root();
  }
  if (builder.is_json()) {
    throw InputError(builder.problem());
  }
  return std::nullopt;
}

}  // namespace airlight
