#include "core/scene/rules.h"

#include <algorithm>

#include "core/scene/json_format.h"

namespace airlight {
namespace {

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : text + " " + std::string(unit);
}

}  // namespace

bool holds_for(const Rule& rule, std::string_view choice) {
  return rule.only_for.empty() || std::ranges::find(rule.only_for, choice) != rule.only_for.end();
}

std::string_view path_within(const Rule& rule, std::string_view prefix) {
  std::string_view rest = rule.key;
  if (!prefix.empty()) {
    if (!rest.starts_with(prefix) || rest.size() <= prefix.size() || rest[prefix.size()] != '.') {
      return {};
    }
    rest.remove_prefix(prefix.size() + 1);
  }
  return rest;
}

std::string_view held_key(const Rule& rule, std::string_view prefix, const void* id, std::string_view choice) {
  if (rule.member.owner != id || !holds_for(rule, choice)) {
    return {};
  }
  const std::string_view path = path_within(rule, prefix);
  return path.find_first_of(".[") == std::string_view::npos ? path : std::string_view();
}

bool Range::contains(double value) const {
  const bool above = minimum_excluded ? value > minimum : value >= minimum;
  const bool below = maximum_excluded ? value < maximum : value <= maximum;
  return above && below;
}

std::string range_text(const Range& range, std::string_view unit) {
  const bool has_minimum = range.minimum > -std::numeric_limits<double>::infinity();
  const bool has_maximum = range.maximum < std::numeric_limits<double>::infinity();
  if (!has_minimum && !has_maximum) {
    return "any";
  }
  if (has_minimum && has_maximum && !range.minimum_excluded && !range.maximum_excluded) {
    return with_unit(format_number(range.minimum) + " to " + format_number(range.maximum), unit);
  }
  std::string text;
  if (has_minimum) {
    text = (range.minimum_excluded ? "above " : "at least ") + format_number(range.minimum);
  }
  if (has_maximum) {
    text += (has_minimum ? " and " : "") + std::string(range.maximum_excluded ? "below " : "at most ") +
            format_number(range.maximum);
  }
  return with_unit(text, unit);
}

std::string expectation(const Rule& rule) {
  const std::string range = range_text(rule.range, rule.unit);
  switch (rule.type) {
    case RuleType::version:
      return "1";
    case RuleType::extends:
      return "a file name or that of a built-in preset";
    case RuleType::text:
      return "a string";
    case RuleType::name:
      return "a string of at least one character";
    case RuleType::boolean:
      return "true or false";
    case RuleType::integer:
      return "a whole number, " + range;
    case RuleType::number:
      return "a number, " + range;
    case RuleType::spectrum:
      return "a number or an array of three, " + range;
    case RuleType::pair:
      return "an array of two numbers, each " + range;
    case RuleType::curve:
      return "a number or an array of three, " + range + ", or a curve {...}";
    case RuleType::shape:
      return "a curve {...}";
    case RuleType::wavelengths:
      return "a whole number, " + range + ", or \"auto\"";
    case RuleType::choice: {
      std::string text = "one of";
      for (std::size_t i = 0; i < rule.choices.size(); ++i) {
        text += (i == 0 ? " " : ", ") + json_choice(rule.choices[i]);
      }
      return text;
    }
    case RuleType::method:
      return "the name of a method";
    case RuleType::exposure:
      return "a number, " + range + ", \"auto\", \"day\" or \"lock:FRAME\"";
    case RuleType::media:
      return "an array of " + range + " media";
    case RuleType::spheres:
      return "an array of " + range + " spheres";
    case RuleType::clouds:
      return "an array of " + range + " clouds";
    case RuleType::angles:
      return "an array of ascending numbers, " + range;
    case RuleType::phase_values:
      return "an array of numbers, " + range + ", or one such array a wavelength";
    case RuleType::layers:
      return "an array of [altitude_km, density], altitudes ascending";
    case RuleType::key_frames:
      return "an array of 1 to 20000 {\"at\": NUMBER, \"/POINTER\": VALUE, ...}";
  }
  return {};
}

}  // namespace airlight
