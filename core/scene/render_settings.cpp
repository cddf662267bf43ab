#include "core/scene/render_settings.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/printable.h"
#include "core/scene/value_reader.h"

namespace airlight {
namespace {

// Keys of `render` beside the method's own.
constexpr std::array<std::string_view, 3> kOfEveryMethod{"method", "wavelengths", "polarisation"};

const ParameterInfo* find_parameter(const MethodInfo& method, std::string_view key) {
  const auto found =
      std::ranges::find_if(method.parameters, [&](const ParameterInfo& parameter) { return parameter.key == key; });
  return found == method.parameters.end() ? nullptr : &*found;
}

const MethodInfo* find_method(const Section& render, std::span<const MethodInfo> methods, std::string& name) {
  const PresetValue* value = render.find("method");
  name = std::string(render.rule("method").default_text);
  if (value != nullptr) {
    const auto* text = std::get_if<std::string>(&value->data);
    if (text == nullptr) {
      render.complain("method", *value, quoted(*value) + " is not a string; expected the name of a method");
      return nullptr;
    }
    name = *text;
  }
  const auto found = std::ranges::find_if(methods, [&](const MethodInfo& method) { return method.name == name; });
  if (found != methods.end()) {
    return &*found;
  }
  std::vector<std::string> names;
  for (const MethodInfo& method : methods) {
    names.emplace_back(method.name);
  }
  const std::string message =
      quoted_text(name) + " is not a method; expected one of " + joined(names) + did_you_mean(name, names);
  render.problems().add(value != nullptr ? *value : render.context(), render.pointer_to("method"), message);
  return nullptr;
}

std::optional<SunFade> read_sun_fade(const Site& site) {
  const auto* object = std::get_if<PresetObject>(&site.value.data);
  if (object == nullptr) {
    site.complain(quoted(site.value) + " is not a fade; expected {\"scale\": number, \"bias\": number}");
    return std::nullopt;
  }
  const std::vector<std::string> known = {"scale", "bias"};
  SunFade fade;
  for (const auto& [key, value] : *object) {
    const std::string pointer = pointer_below(site.pointer, key);
    if (key != "scale" && key != "bias") {
      const std::string suggestion = did_you_mean(key, known);
      site.problems.add(value, pointer,
                        "unknown key" + (suggestion.empty() ? "; expected one of scale, bias" : suggestion));
      continue;
    }
    read_number({site.problems, value, pointer, site.rule}, key == "scale" ? fade.scale : fade.bias);
  }
  for (const std::string& key : known) {
    if (!object->contains(key)) {
      site.problems.add(site.value, pointer_below(site.pointer, key), "missing; expected " + expectation(site.rule));
    }
  }
  return fade;
}

std::optional<TableSize> read_table_size(const Site& site) {
  const auto* array = std::get_if<PresetArray>(&site.value.data);
  TableSize size{};
  if (array == nullptr || array->size() != size.size()) {
    site.complain(quoted(site.value) + " is not a table size; expected [width, height], each " +
                  range_text(site.rule.range, site.rule.unit));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < size.size(); ++i) {
    read_integer({site.problems, (*array)[i], pointer_below(site.pointer, std::to_string(i)), site.rule}, size[i]);
  }
  return size;
}

// The value by its kind. A wrong value is reported, and the result is the default.
ParameterValue read_parameter(const Section& render, const ParameterInfo& parameter, const PresetValue& value) {
  const Rule rule = rule_of(parameter);
  const Site site{render.problems(), value, render.pointer_to(parameter.key), rule};
  ParameterValue result = parameter.default_value;
  switch (parameter.kind) {
    case ParameterKind::boolean:
      read_boolean(site, result.emplace<bool>());
      break;
    case ParameterKind::integer:
      read_integer(site, result.emplace<int>());
      break;
    case ParameterKind::number:
      read_number(site, result.emplace<double>());
      break;
    case ParameterKind::choice: {
      std::size_t index = 0;
      if (read_choice(site, index)) {
        result = std::string(parameter.choices[index]);
      }
      break;
    }
    case ParameterKind::table_size:
      result = read_table_size(site).value_or(TableSize{});
      break;
    case ParameterKind::sun_fade:
      result = read_sun_fade(site).value_or(SunFade{});
      break;
  }
  return result;
}

void refuse_key(const Section& render, const std::string& key, const PresetValue& value, const MethodInfo* chosen,
                std::span<const MethodInfo> methods) {
  const std::string others = joined_of(methods, [&](const MethodInfo& method) {
    return find_parameter(method, key) != nullptr ? method.name : std::string_view();
  });
  if (!others.empty()) {
    // A key that no method has is refused even if inherited: a misspelt key is wrong in any file.
    if (chosen != nullptr && !value.inherited) {
      render.complain(key, value,
                      "the method " + json_string(chosen->name) + " does not take this key; it belongs to " + others +
                          ": remove it");
    }
    return;
  }
  std::vector<std::string> known(kOfEveryMethod.begin(), kOfEveryMethod.end());
  for (const MethodInfo& method : methods) {
    if (chosen == nullptr || &method == chosen) {
      for (const ParameterInfo& parameter : method.parameters) {
        known.emplace_back(parameter.key);
      }
    }
  }
  const std::string suggestion = did_you_mean(key, known);
  render.complain(key, value, "unknown key" + (suggestion.empty() ? "; `airlight methods` lists them" : suggestion));
}

}  // namespace

Rule rule_of(const ParameterInfo& parameter) {
  // A method's "no limit" ends where squares of numbers exceed a 32-bit float.
  constexpr double kLargest = 1e9;
  Rule rule{
      .key = parameter.key,
      .range = {.minimum = std::max(parameter.minimum, -kLargest), .maximum = std::min(parameter.maximum, kLargest)},
      .choices = parameter.choices,
      .meaning = parameter.meaning};
  switch (parameter.kind) {
    case ParameterKind::boolean:
      rule.type = RuleType::boolean;
      break;
    case ParameterKind::integer:
    case ParameterKind::table_size:
      rule.type = RuleType::integer;
      break;
    case ParameterKind::choice:
      rule.type = RuleType::choice;
      break;
    case ParameterKind::number:
    case ParameterKind::sun_fade:
      break;
  }
  return rule;
}

std::string json_text(const ParameterValue& value) {
  struct Writer {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(int number) const { return std::to_string(number); }
    std::string operator()(double number) const { return format_number(number); }
    std::string operator()(const std::string& choice) const { return json_choice(choice); }
    std::string operator()(const TableSize& size) const {
      return "[" + std::to_string(size[0]) + ", " + std::to_string(size[1]) + "]";
    }
    std::string operator()(const SunFade& fade) const {
      return "{\"scale\": " + format_number(fade.scale) + ", \"bias\": " + format_number(fade.bias) + "}";
    }
  };
  return std::visit(Writer{}, value);
}

RenderSettings read_render_settings(const Section& root, std::span<const MethodInfo> methods) {
  const Section render = root.child("render");
  RenderSettings settings;
  const MethodInfo* method = find_method(render, methods, settings.method);
  if (method != nullptr) {
    for (const ParameterInfo& parameter : method->parameters) {
      settings.parameters.emplace(parameter.key, parameter.default_value);
    }
  }
  if (render.object() == nullptr) {
    return settings;
  }
  render.fill(settings);
  for (const auto& [key, value] : *render.object()) {
    if (std::ranges::find(kOfEveryMethod, key) != kOfEveryMethod.end()) {
      continue;
    }
    const ParameterInfo* parameter = method == nullptr ? nullptr : find_parameter(*method, key);
    if (parameter != nullptr) {
      settings.parameters.insert_or_assign(key, read_parameter(render, *parameter, value));
    } else {
      refuse_key(render, key, value, method, methods);
    }
  }
  return settings;
}

}  // namespace airlight
