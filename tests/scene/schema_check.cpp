#include "tests/scene/schema_check.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>
#include <vector>

namespace airlight::test {
namespace {

using Json = nlohmann::json;

bool has_type(const Json& value, const std::string& type) {
  if (type == "integer") {
    return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
  }
  return (type == "number" && value.is_number()) || (type == "string" && value.is_string()) ||
         (type == "boolean" && value.is_boolean()) || (type == "array" && value.is_array()) ||
         (type == "object" && value.is_object());
}

bool fits(const Json& schema, const Json& value) {
  return schema_problem(schema, value).empty();
}

bool number_fits(const std::string& keyword, const Json& limit, const Json& value) {
  if (!value.is_number()) {
    return true;
  }
  const double x = value.get<double>();
  const double bound = limit.get<double>();
  return keyword == "minimum"            ? x >= bound
         : keyword == "maximum"          ? x <= bound
         : keyword == "exclusiveMinimum" ? x > bound
                                         : x < bound;
}

bool array_fits(const std::string& keyword, const Json& limit, const Json& value) {
  return !value.is_array() ||
         (keyword == "minItems" ? value.size() >= limit.get<std::size_t>() : value.size() <= limit.get<std::size_t>());
}

bool required_fits(const Json& names, const Json& value) {
  return !value.is_object() ||
         std::ranges::all_of(names, [&](const Json& name) { return value.contains(name.get<std::string>()); });
}

// The schemas of those patterns that a key matches.
std::vector<Json> pattern_schemas(const Json& schema, const std::string& key) {
  std::vector<Json> found;
  const auto patterns = schema.find("patternProperties");
  if (patterns != schema.end()) {
    for (const auto& [pattern, value] : patterns->items()) {
      if (std::regex_search(key, std::regex(pattern))) {
        found.push_back(value);
      }
    }
  }
  return found;
}

// The keywords that concern the value itself.
bool own_keyword_fits(const std::string& keyword, const Json& argument, const Json& value, const Json& schema) {
  if (keyword == "$schema" || keyword == "title" || keyword == "description" || keyword == "default" ||
      keyword == "then") {
    return true;
  }
  if (keyword == "type") {
    return has_type(value, argument);
  }
  if (keyword == "const") {
    return value == argument;
  }
  if (keyword == "enum") {
    return std::ranges::find(argument, value) != argument.end();
  }
  if (keyword == "minimum" || keyword == "maximum" || keyword == "exclusiveMinimum" || keyword == "exclusiveMaximum") {
    return number_fits(keyword, argument, value);
  }
  if (keyword == "minItems" || keyword == "maxItems") {
    return array_fits(keyword, argument, value);
  }
  if (keyword == "minLength") {
    return !value.is_string() || value.get<std::string>().size() >= argument.get<std::size_t>();
  }
  if (keyword == "pattern") {
    return !value.is_string() || std::regex_search(value.get<std::string>(), std::regex(argument.get<std::string>()));
  }
  if (keyword == "required") {
    return required_fits(argument, value);
  }
  if (keyword == "anyOf") {
    return std::ranges::any_of(argument, [&](const Json& option) { return fits(option, value); });
  }
  if (keyword == "additionalProperties") {
    return !value.is_object() || std::ranges::all_of(value.items(), [&](const auto& item) {
      return schema["properties"].contains(item.key()) || !pattern_schemas(schema, item.key()).empty();
    });
  }
  throw std::logic_error("unknown schema keyword " + keyword);
}

std::string properties_problem(const Json& properties, const Json& value, const std::string& pointer) {
  if (value.is_object()) {
    for (const auto& [key, schema] : properties.items()) {
      if (value.contains(key)) {
        if (std::string problem = schema_problem(schema, value[key], pointer + "/" + key); !problem.empty()) {
          return problem;
        }
      }
    }
  }
  return {};
}

std::string patterns_problem(const Json& schema, const Json& value, const std::string& pointer) {
  if (!value.is_object()) {
    return {};
  }
  for (const auto& [key, item] : value.items()) {
    for (const Json& pattern : pattern_schemas(schema, key)) {
      if (std::string problem = schema_problem(pattern, item, pointer + "/" + key); !problem.empty()) {
        return problem;
      }
    }
  }
  return {};
}

std::string items_problem(const Json& schema, bool one_each, const Json& value, const std::string& pointer) {
  for (std::size_t i = 0; value.is_array() && i < value.size() && (!one_each || i < schema.size()); ++i) {
    const Json& item_schema = one_each ? schema[i] : schema;
    if (std::string problem = schema_problem(item_schema, value[i], pointer + "/" + std::to_string(i));
        !problem.empty()) {
      return problem;
    }
  }
  return {};
}

}  // namespace

std::string schema_problem(const Json& schema, const Json& value, const std::string& pointer) {
  if (schema.is_boolean()) {
    return schema.get<bool>() ? "" : pointer + ": not allowed";
  }
  for (const auto& [keyword, argument] : schema.items()) {
    std::string problem;
    if (keyword == "properties") {
      problem = properties_problem(argument, value, pointer);
    } else if (keyword == "patternProperties") {
      problem = patterns_problem(schema, value, pointer);
    } else if (keyword == "items" || keyword == "prefixItems") {
      problem = items_problem(argument, keyword == "prefixItems", value, pointer);
    } else if (keyword == "if") {
      problem = fits(argument, value) ? schema_problem(schema["then"], value, pointer) : "";
    } else if (keyword == "allOf") {
      for (const Json& part : argument) {
        problem = problem.empty() ? schema_problem(part, value, pointer) : problem;
      }
    } else if (!own_keyword_fits(keyword, argument, value, schema)) {
      problem = pointer + ": " + keyword;
    }
    if (!problem.empty()) {
      return problem;
    }
  }
  return {};
}

}  // namespace airlight::test
