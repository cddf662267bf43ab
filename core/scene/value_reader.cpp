#include "core/scene/value_reader.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/suggestion.h"

namespace airlight {
namespace {

void complain_of_type(const Site& site, std::string_view type) {
  site.complain(quoted(site.value) + " is not " + std::string(type) + "; expected " + expectation(site.rule));
}

}  // namespace

std::string out_of_range(double value, const Rule& rule) {
  const Range& range = rule.range;
  const bool closed = std::isfinite(range.minimum) && std::isfinite(range.maximum) && !range.minimum_excluded &&
                      !range.maximum_excluded;
  const std::string hint = rule.hint.empty() ? "" : "; " + std::string(rule.hint);
  return format_number(value) + (closed ? " is outside " : " is not ") + range_text(range, rule.unit) + hint;
}

std::string did_you_mean(std::string_view typed, std::span<const std::string> names) {
  const auto nearest = nearest_name(typed, names);
  return nearest ? "; did you mean " + json_string(*nearest) + "?" : "";
}

void read_number(const Site& site, double& out) {
  const auto* number = std::get_if<double>(&site.value.data);
  if (number == nullptr) {
    site.complain(quoted(site.value) + " is not a number; expected " +
                  (site.rule.type == RuleType::layers || site.rule.type == RuleType::pair
                       ? range_text(site.rule.range, site.rule.unit)
                       : expectation(site.rule)));
  } else if (!site.rule.range.contains(*number)) {
    site.complain(out_of_range(*number, site.rule));
  } else {
    out = *number;
  }
}

void read_integer(const Site& site, int& out) {
  const auto* number = std::get_if<double>(&site.value.data);
  if (number != nullptr && std::floor(*number) != *number) {
    complain_of_type(site, "whole");
    return;
  }
  double whole = out;
  read_number(site, whole);
  out = static_cast<int>(whole);
}

void read_boolean(const Site& site, bool& out) {
  if (const auto* flag = std::get_if<bool>(&site.value.data)) {
    out = *flag;
  } else {
    complain_of_type(site, "a boolean");
  }
}

void read_text(const Site& site, std::string& out) {
  const auto* text = std::get_if<std::string>(&site.value.data);
  if (text == nullptr) {
    complain_of_type(site, "a string");
  } else if (site.rule.type == RuleType::name && text->empty()) {
    site.complain("empty; expected " + expectation(site.rule));
  } else {
    out = *text;
  }
}

void read_spectrum(const Site& site, Spectrum& out) {
  const auto* array = std::get_if<PresetArray>(&site.value.data);
  if (array == nullptr) {
    double gray = out[0];
    read_number(site, gray);
    out = {gray, gray, gray};
    return;
  }
  if (array->size() != out.size()) {
    complain_of_type(site, "a spectrum");
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    read_number({site.problems, (*array)[i], pointer_below(site.pointer, std::to_string(i)), site.rule}, out[i]);
  }
}

void read_pair(const Site& site, std::array<double, 2>& out) {
  const auto* array = std::get_if<PresetArray>(&site.value.data);
  if (array == nullptr || array->size() != out.size()) {
    complain_of_type(site, "a pair");
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    read_number({site.problems, (*array)[i], pointer_below(site.pointer, std::to_string(i)), site.rule}, out[i]);
  }
}

bool read_choice(const Site& site, std::size_t& out) {
  const auto* text = std::get_if<std::string>(&site.value.data);
  const auto* flag = std::get_if<bool>(&site.value.data);
  const std::string name = text != nullptr ? *text : flag != nullptr && *flag ? "true" : "false";
  const auto found = std::ranges::find(site.rule.choices, name);
  const bool known = found != site.rule.choices.end();
  if (text == nullptr && (flag == nullptr || !known)) {
    complain_of_type(site, "a string");
    return false;
  }
  if (!known) {
    const std::vector<std::string> names(site.rule.choices.begin(), site.rule.choices.end());
    site.complain(quoted(site.value) + " is unknown; expected " + expectation(site.rule) + did_you_mean(name, names));
    return false;
  }
  out = static_cast<std::size_t>(found - site.rule.choices.begin());
  return true;
}

}  // namespace airlight
