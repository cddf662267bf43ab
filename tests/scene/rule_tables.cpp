// The tables of presets/README.md.

#include <gtest/gtest.h>

#include "core/scene/render_settings.h"
#include "core/scene/rules.h"
#include "tests/scene/rule_docs.h"

namespace airlight::test {
namespace {

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "`" : ", `") + std::string(name) + "`";
  }
  return text;
}

std::string type_text(const Rule& rule) {
  switch (rule.type) {
    case RuleType::choice:
      return joined(rule.choices);
    case RuleType::layers:
      return "array of [km, " + range_text(rule.range, rule.unit) + "]";
    default:
      return expectation(rule);
  }
}

std::string default_text(const Rule& rule) {
  if (rule.required) {
    return "required";
  }
  if (rule.default_text.empty()) {
    return rule.type == RuleType::text ? "`\"\"`" : "none";
  }
  if (rule.type == RuleType::pair) {
    return "`[" + std::string(rule.default_text) + ", " + std::string(rule.default_text) + "]`";
  }
  const bool is_word = rule.type == RuleType::choice || rule.type == RuleType::method ||
                       rule.type == RuleType::exposure || rule.type == RuleType::wavelengths;
  return is_word ? "`\"" + std::string(rule.default_text) + "\"`" : "`" + std::string(rule.default_text) + "`";
}

std::string row(const std::string& key, const std::string& type, const std::string& fallback,
                const std::string& meaning) {
  // It would end the table's cell.
  EXPECT_EQ((type + fallback + meaning).find('|'), std::string::npos) << key;
  return "| " + key + " | " + type + " | " + fallback + " | " + meaning + " |\n";
}

std::string parameter_type(const ParameterInfo& parameter) {
  const Rule rule = rule_of(parameter);
  switch (parameter.kind) {
    case ParameterKind::table_size:
      return "[width, height], each " + range_text(rule.range, rule.unit);
    case ParameterKind::sun_fade:
      return "{\"scale\": number, \"bias\": number}";
    default:
      return type_text(rule);
  }
}

}  // namespace

std::string key_table() {
  std::string text = "| key | type, range, unit | default | meaning |\n|---|---|---|---|\n";
  for (const Rule& rule : rules()) {
    const std::string condition = rule.only_for.empty() ? "" : " (" + joined(rule.only_for) + ")";
    text += row("`" + std::string(rule.key) + "`" + condition, type_text(rule), default_text(rule),
                std::string(rule.meaning));
  }
  return text;
}

std::string parameter_table(std::span<const MethodInfo> methods) {
  std::string text = "| method | key | type, range | default | meaning |\n|---|---|---|---|---|\n";
  for (const MethodInfo& method : methods) {
    for (const ParameterInfo& parameter : method.parameters) {
      const std::string fallback = json_text(parameter.default_value);
      text += "| `" + std::string(method.name) + "` " +
              row("`render." + std::string(parameter.key) + "`", parameter_type(parameter),
                  fallback.empty() ? "absent" : "`" + fallback + "`", std::string(parameter.meaning));
    }
    if (method.parameters.empty()) {
      text += "| `" + std::string(method.name) + "` " + row("none", "", "", "");
    }
  }
  return text;
}

}  // namespace airlight::test
