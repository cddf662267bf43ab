// Options and positionals as CLI11's, each value judged before it is stored.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "app/cli/cli11.h"
#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/suggestion.h"

namespace airlight::cli {
namespace {

using Words = std::vector<std::string>;

std::string expected_number(bool whole, const std::optional<Range>& range, Percent percent) {
  const bool share = percent == Percent::share;
  std::string text = share ? "a percentage" : whole ? "a whole number" : "a number";
  const auto end = [&](double value) { return share ? rounded(100.0 * value, 6) + "%" : format_number(value); };
  if (range) {
    text += std::isinf(range->maximum) ? " of at least " + end(range->minimum)
                                       : " from " + end(range->minimum) + " to " + end(range->maximum);
  }
  return text + (share ? "; write for example 0.5% or 0.005" : "");
}

// The type of the value that a target holds, whether single, optional or repeated.
template <class T>
struct Held {
  using type = T;
};
template <class T>
struct Held<std::optional<T>> {
  using type = T;
};
template <class T>
struct Held<std::vector<T>> {
  using type = T;
};

template <class Word>
bool holds(const Target& target) {
  return std::visit(
      [](auto* to) { return std::is_same_v<typename Held<std::remove_pointer_t<decltype(to)>>::type, Word>; }, target);
}

CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& word) {
        return word.empty() ? std::string("the value is empty; give one or leave the option out") : std::string();
      },
      "");
}

CLI::Validator one_of(const Words& choices) {
  return CLI::Validator(
      [choices](std::string& word) {
        const bool known = std::ranges::find(choices, word) != choices.end();
        return known ? std::string() : "'" + word + "' is not one of " + joined(choices) + did_you_mean(word, choices);
      },
      "");
}

// CLI11 would read a number through a long double, rounded twice, and accept infinity. A leading + is dropped, as
// people write it; a % is dropped according to its meaning.
template <class T>
CLI::Validator a_number(const std::optional<Range>& range, Percent percent) {
  return CLI::Validator(
      [range, percent](std::string& word) {
        std::string digits = word.size() > 1 && word[0] == '+' ? word.substr(1) : word;
        const bool signed_percent = percent != Percent::no && digits.size() > 1 && digits.back() == '%';
        digits.resize(digits.size() - (signed_percent ? 1 : 0));
        const std::optional<T> value = number_from<T>(digits);
        const bool hundredths = signed_percent && percent == Percent::share;
        const double number = static_cast<double>(value.value_or(T{})) / (hundredths ? 100.0 : 1.0);
        if (!value || (range && (number < range->minimum || number > range->maximum))) {
          return "'" + word + "' is not " + expected_number(std::is_integral_v<T>, range, percent);
        }
        word = hundredths ? shortest(number) : digits;
        return std::string();
      },
      "");
}

template <class T>
T value_from(const std::string& word) {
  if constexpr (std::is_same_v<T, std::string>) {
    return word;
  } else {
    return number_from<T>(word).value();  // already checked
  }
}

// CLI11 calls it with the words that have passed the checks.
CLI::callback_t store_in(const Target& target) {
  return [target](const Words& words) {
    std::visit(
        [&](auto* to) {
          using T = std::remove_pointer_t<decltype(to)>;
          using Value = typename Held<T>::type;
          if constexpr (std::is_same_v<T, std::vector<Value>>) {
            std::transform(words.begin(), words.end(), std::back_inserter(*to), value_from<Value>);
          } else if constexpr (!std::is_same_v<T, bool>) {
            *to = value_from<Value>(words.back());
          }
        },
        target);
    return true;
  };
}

// CLI11 runs transform() before check().
void judge(CLI::Option& option, const Target& target, const std::optional<Range>& range, const Words& choices,
           Percent percent) {
  if (holds<double>(target)) {
    option.transform(a_number<double>(range, percent));
  } else if (holds<int>(target)) {
    option.transform(a_number<int>(range, Percent::no));
  } else {
    option.check(not_empty());
  }
  if (!choices.empty()) {
    option.check(one_of(choices));
  }
}

CLI::Option* add_option(CLI::App& app, const Option& option) {
  if (is_flag(option)) {
    return app.add_flag(option.names, *std::get<bool*>(option.target), full_help(option))->disable_flag_override();
  }
  CLI::Option* added = app.add_option(option.names, store_in(option.target), full_help(option));
  added->option_text(option.metavar)->type_size(1)->expected(1)->allow_extra_args(false);
  added->multi_option_policy(is_repeatable(option.target) ? CLI::MultiOptionPolicy::TakeAll
                                                          : CLI::MultiOptionPolicy::TakeLast);
  judge(*added, option.target, option.range, option.choices, option.percent);
  return added;
}

void add_positional(CLI::App& app, const Positional& positional) {
  const bool list = is_repeatable(positional.target);
  CLI::Option* added = app.add_option(positional.metavar, store_in(positional.target), positional.help);
  added->option_text(" ")->type_size(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  added->expected(1, list ? -1 : 1)->allow_extra_args(list)->required(positional.required);
  judge(*added, positional.target, {}, positional.choices, Percent::no);
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  std::vector<std::string> long_names;
  std::ranges::copy_if(names, std::back_inserter(long_names), [](const std::string& name) { return name.size() > 2; });
  const std::optional<std::string> nearest = nearest_name(word, long_names);
  return nearest ? " (did you mean '" + *nearest + "'?)" : std::string();
}

bool is_repeatable(const Target& target) {
  return std::holds_alternative<std::vector<std::string>*>(target) ||
         std::holds_alternative<std::vector<double>*>(target);
}

std::unique_ptr<CLI::App> cli11_app(const Command& command) {
  auto app = std::make_unique<CLI::App>(command.summary);
  app->set_help_flag();
  app->allow_extras();
  for (const Option& option : command.options) {
    add_option(*app, option)->group(option.group.empty() ? "Options" : option.group);
  }
  add_option(*app, help_option())
      ->group(command.options.empty() || command.options.back().group.empty() ? "Options"
                                                                              : command.options.back().group);
  for (const Positional& positional : command.positionals) {
    add_positional(*app, positional);
  }
  return app;
}

}  // namespace airlight::cli
