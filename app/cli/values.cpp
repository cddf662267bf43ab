// Words -> values: every conversion and its refusal.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "app/cli/cli.h"
#include "app/cli/suggest.h"
#include "core/error.h"

namespace airlight::cli {
namespace {

std::string number_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string expected_number(bool whole, const std::optional<Range>& range) {
  std::string text = whole ? "a whole number" : "a number";
  if (range) {
    const bool open = std::isinf(range->maximum);
    text += open ? " of at least " + number_text(range->minimum)
                 : " from " + number_text(range->minimum) + " to " + number_text(range->maximum);
  }
  return text;
}

// The whole word must be one finite number; a leading + is allowed as people write it.
template <class T>
T parse_number(const std::string& word, const std::string& place, const std::optional<Range>& range) {
  const char* first = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  const char* last = word.data() + word.size();
  T value{};
  const auto parsed = std::from_chars(first, last, value);
  bool good = parsed.ec == std::errc() && parsed.ptr == last;
  if constexpr (std::is_floating_point_v<T>) {
    good = good && std::isfinite(value);
  }
  const double as_double = static_cast<double>(value);
  if (good && range) {
    good = as_double >= range->minimum && as_double <= range->maximum;
  }
  if (!good) {
    throw InputError(place + ": '" + word + "' is not " + expected_number(std::is_integral_v<T>, range));
  }
  return value;
}

void check_choice(const std::string& word, const std::string& place, const std::vector<std::string>& choices) {
  if (!choices.empty() && std::find(choices.begin(), choices.end(), word) == choices.end()) {
    throw InputError(place + ": '" + word + "' is not one of " + joined(choices) + did_you_mean(word, choices));
  }
}

template <class T>
T parse(const std::string& word, const std::string& place, const std::optional<Range>& range,
        const std::vector<std::string>& choices) {
  check_choice(word, place, choices);
  if constexpr (std::is_same_v<T, std::string>) {
    if (word.empty()) {
      throw InputError(place + ": the value is empty; give one or leave the option out");
    }
    return word;
  } else {
    return parse_number<T>(word, place, range);
  }
}

template <class T>
struct Held {
  using type = T;
};
template <class T>
struct Held<std::optional<T>> {
  using type = T;
};

}  // namespace

bool is_repeatable(const Target& target) {
  return std::holds_alternative<std::vector<std::string>*>(target) ||
         std::holds_alternative<std::vector<double>*>(target);
}

void store(const Target& target, const std::vector<std::string>& words, const std::string& place,
           const std::optional<Range>& range, const std::vector<std::string>& choices) {
  const bool flag = std::holds_alternative<bool*>(target);
  if (!flag && !is_repeatable(target) && words.size() > 1) {
    throw InputError(place + ": given " + std::to_string(words.size()) + " times (" + joined(words) +
                     "); give it once");
  }
  std::visit(
      [&](auto* to) {
        using T = std::remove_pointer_t<decltype(to)>;
        if constexpr (std::is_same_v<T, bool>) {
          *to = true;
        } else if constexpr (std::is_same_v<T, std::vector<std::string>> || std::is_same_v<T, std::vector<double>>) {
          for (const std::string& word : words) {
            to->push_back(parse<typename T::value_type>(word, place, range, choices));
          }
        } else {
          *to = parse<typename Held<T>::type>(words.front(), place, range, choices);
        }
      },
      target);
}

}  // namespace airlight::cli
