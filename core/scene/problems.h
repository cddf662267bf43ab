#pragma once
// Collects the problems of a preset, so that all are reported at once.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/preset.h"

namespace airlight {

class Problems {
 public:
  // `at` gives file and line; for a missing key it is the object that lacks the key.
  void add(const PresetValue& at, std::string_view pointer, std::string_view message);

  // From here on a pointer is told as `told` says; a problem for whose pointer it has none is left out. Empty: all as
  // they are.
  using Told = std::function<std::optional<std::string>(std::string_view pointer)>;
  void tell_pointers(Told told) { told_ = std::move(told); }

  bool any() const { return !problems_.empty(); }
  std::size_t count() const { return problems_.size(); }

  // Throws InputError with one line for each problem, by file and line, and a count of those beyond kMostProblems.
  // Returns when there is none.
  void throw_if_any();

 private:
  struct Problem {
    std::string source;
    int line = 0;
    std::string text;
  };
  std::vector<Problem> problems_;
  Told told_;
};

// A JSON pointer in a message: printable, its first kLongestQuote bytes.
std::string shown_pointer(std::string_view pointer);

// How a message quotes a value: 1.2, "tall" (shortened), true, null, an array of 3, an object.
std::string quoted(const PresetValue& value);

}  // namespace airlight
