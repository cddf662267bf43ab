// The JSON Schema. It sees one file, not what the file inherits. A key that a profile or projection does not have is
// refused where the file itself names the profile. Required keys may be inherited where the file extends another.

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/scene/curve_reader.h"
#include "core/scene/json_format.h"
#include "core/scene/render_settings.h"
#include "core/scene/rules.h"
#include "core/scene/scene.h"
#include "tests/scene/rule_docs.h"

namespace airlight::test {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number_schema(const Range& range, std::string_view type = "number") {
  OrderedJson schema = {{"type", type}};
  schema[range.minimum_excluded ? "exclusiveMinimum" : "minimum"] = range.minimum;
  schema[range.maximum_excluded ? "exclusiveMaximum" : "maximum"] = range.maximum;
  return schema;
}

OrderedJson array_schema(const OrderedJson& items, int minimum, int maximum) {
  return {{"type", "array"}, {"items", items}, {"minItems", minimum}, {"maxItems", maximum}};
}

OrderedJson choices(const Rule& rule) {
  OrderedJson list = OrderedJson::array();
  for (const std::string_view name : rule.choices) {
    list.push_back(OrderedJson::parse(json_choice(name)));
  }
  return list;
}

OrderedJson layers_schema(const Rule& rule) {
  const OrderedJson pair = {{"type", "array"},
                            {"prefixItems", {number_schema(kLayerAltitude), number_schema(rule.range)}},
                            {"minItems", 2},
                            {"maxItems", 2}};
  return array_schema(pair, 1, kMaxDensityLayers);
}

// The forms of core/scene/curve_reader.h.
OrderedJson curve_schema(const Range& range) {
  const OrderedJson value = number_schema(range);
  const OrderedJson object = {{"type", "object"}, {"additionalProperties", false}};
  const auto form = [&](const OrderedJson& properties, const OrderedJson& required) {
    OrderedJson schema = object;
    schema["properties"] = properties;
    schema["required"] = required;
    return schema;
  };
  const OrderedJson factor = {{"type", "number"}, {"minimum", 0.0}};
  OrderedJson plain = OrderedJson::array();
  for (const std::string_view name : kPlainCurveNames) {
    plain.push_back(name);
  }
  return {{"anyOf",
           {form({{"wavelengths_nm", array_schema(number_schema(kWavelength), 2, kMaxCurveSamples)},
                  {"values", array_schema(value, 2, kMaxCurveSamples)}},
                 {"wavelengths_nm", "values"}),
            form({{"file", {{"type", "string"}}}, {"scale", factor}}, {"file"}),
            form({{"at_nm", number_schema(kWavelength)}, {"value", value}, {"exponent", number_schema(kExponent)}},
                 {"at_nm", "value", "exponent"}),
            form({{"named", {{"enum", plain}}}, {"scale", factor}}, {"named"}),
            form({{"named", {{"const", "ozone"}}}, {"dobson_units", number_schema(kDobsonUnits)}},
                 {"named", "dobson_units"}),
            form({{"black_body_k", number_schema(kKelvin)}}, {"black_body_k"})}}};
}

OrderedJson type_schema(const Rule& rule) {
  switch (rule.type) {
    case RuleType::version:
      return {{"const", 1}};
    case RuleType::extends:
    case RuleType::text:
    case RuleType::method:
      return {{"type", "string"}};
    case RuleType::name:
      return {{"type", "string"}, {"minLength", 1}};
    case RuleType::boolean:
      return {{"type", "boolean"}};
    case RuleType::integer:
      return number_schema(rule.range, "integer");
    case RuleType::number:
      return number_schema(rule.range);
    case RuleType::spectrum:
      return {{"anyOf", {number_schema(rule.range), array_schema(number_schema(rule.range), 3, 3)}}};
    case RuleType::pair:
      return array_schema(number_schema(rule.range), 2, 2);
    case RuleType::curve: {
      OrderedJson schema = curve_schema(rule.range);
      schema["anyOf"].insert(schema["anyOf"].begin(),
                             {number_schema(rule.range), array_schema(number_schema(rule.range), 3, 3)});
      return schema;
    }
    case RuleType::shape:
      return curve_schema(kShapeValue);
    case RuleType::wavelengths:
      return {{"anyOf", {number_schema(rule.range, "integer"), OrderedJson{{"const", "auto"}}}}};
    case RuleType::choice:
      return {{"enum", choices(rule)}};
    case RuleType::exposure:
      return {{"anyOf",
               {number_schema(rule.range), OrderedJson{{"enum", {"auto", "day"}}},
                OrderedJson{{"type", "string"}, {"pattern", "^lock:[0-9]{1,8}$"}}}}};
    case RuleType::media:
    case RuleType::spheres:
    case RuleType::clouds:
      return {{"type", "array"}, {"minItems", rule.range.minimum}, {"maxItems", rule.range.maximum}};
    case RuleType::angles:
      return array_schema(number_schema(rule.range), 1, kMaxCurveSamples);
    case RuleType::phase_values: {
      const OrderedJson row = array_schema(number_schema(rule.range), 2, kMaxCurveSamples);
      return {{"anyOf", {row, array_schema(row, 1, kMaxCurveSamples)}}};
    }
    case RuleType::layers:
      return layers_schema(rule);
    case RuleType::key_frames:
      return {{"type", "array"}, {"minItems", 1}};
  }
  return {};
}

// The union of several rules for one key, each for its own choices.
Rule widest(const Rule& rule) {
  Rule all = rule;
  for (const Rule& other : rules()) {
    if (other.key != rule.key) {
      continue;
    }
    const Range& range = other.range;
    if (range.minimum < all.range.minimum || (range.minimum == all.range.minimum && !range.minimum_excluded)) {
      all.range.minimum = range.minimum;
      all.range.minimum_excluded = range.minimum_excluded;
    }
    if (range.maximum > all.range.maximum || (range.maximum == all.range.maximum && !range.maximum_excluded)) {
      all.range.maximum = range.maximum;
      all.range.maximum_excluded = range.maximum_excluded;
    }
  }
  return all;
}

// The description ends with the unit; the default is what an editor fills in.
OrderedJson annotated(OrderedJson schema, const Rule& rule) {
  std::string text(rule.meaning);
  if (!rule.unit.empty()) {
    text += " [" + std::string(rule.unit) + "]";
  }
  schema["description"] = text;
  if (!rule.default_text.empty() && rule.only_for.empty()) {
    const OrderedJson value = OrderedJson::parse(rule.default_text, nullptr, false);
    schema["default"] = value.is_discarded() ? OrderedJson(rule.default_text) : value;
  }
  return schema;
}

OrderedJson object_schema() {
  return {{"type", "object"}, {"properties", OrderedJson::object()}, {"additionalProperties", false}};
}

// The schema of the object that holds a rule's key, made on the way: "media[].density" from the root.
OrderedJson& owner_of(OrderedJson& root, std::string_view key) {
  OrderedJson* at = &root;
  for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
    std::string name(key.substr(0, dot));
    key.remove_prefix(dot + 1);
    const bool is_array = name.ends_with("[]");
    if (is_array) {
      name.resize(name.size() - 2);
    }
    OrderedJson& property = (*at)["properties"][name];
    OrderedJson& object = is_array ? property["items"] : property;
    if (object.is_null()) {
      object = object_schema();
    }
    at = &object;
  }
  return *at;
}

std::string last_part(std::string_view key) {
  return std::string(key.substr(key.rfind('.') + 1));
}

// Rules for particular choices: in a file that states the choice, that choice's own rule holds and no other key.
void add_choice(OrderedJson& root, const Rule& selector) {
  OrderedJson& owner = owner_of(root, selector.key);
  const std::string prefix(selector.key.substr(0, selector.key.rfind('.') + 1));
  const std::string selector_name = last_part(selector.key);
  for (const std::string_view choice : selector.choices) {
    OrderedJson then = OrderedJson::object();
    std::map<std::string, bool> taken;
    for (const Rule& rule : rules()) {
      if (!rule.key.starts_with(prefix) || rule.only_for.empty()) {
        continue;
      }
      const std::string name = last_part(rule.key);
      const bool mine = std::ranges::find(rule.only_for, choice) != rule.only_for.end();
      taken[name] = taken[name] || mine;
      if (mine) {
        then["properties"][name] = type_schema(rule);
        if (rule.required) {
          then["required"].push_back(name);
        }
      }
    }
    for (const auto& [name, is_taken] : taken) {
      if (!is_taken) {
        then["properties"][name] = false;
      }
    }
    if (!then.empty()) {
      owner["allOf"].push_back(
          {{"if", {{"properties", {{selector_name, {{"const", choice}}}}}, {"required", {selector_name}}}},
           {"then", then}});
    }
  }
}

// A map of the whole sphere cannot be tilted.
void add_tilt(OrderedJson& root) {
  for (OrderedJson& condition : root["properties"]["camera"]["allOf"]) {
    const OrderedJson& projection = condition["if"]["properties"]["projection"]["const"];
    if (projection == "equirectangular" || projection == "cube" || projection == "octahedral") {
      condition["then"]["properties"]["pitch_deg"] = {{"const", 0}};
      condition["then"]["properties"]["roll_deg"] = {{"const", 0}};
    }
  }
}

// A key frame's other keys are pointers; resolve() checks what they lead to.
void add_key_frames(OrderedJson& root) {
  OrderedJson& sequence = root["properties"]["sequence"];
  sequence["required"] = {"frames"};
  OrderedJson& frame = sequence["properties"]["frames"]["items"];
  frame["required"] = {"at"};
  const OrderedJson number = {{"type", "number"}};
  frame["patternProperties"]["^/"] = {{"anyOf", {number, array_schema(number, 3, 3)}}};
}

OrderedJson parameter_schema(const ParameterInfo& parameter) {
  const Rule rule = rule_of(parameter);
  switch (parameter.kind) {
    case ParameterKind::table_size:
      return array_schema(type_schema(rule), 2, 2);
    case ParameterKind::sun_fade: {
      OrderedJson schema = object_schema();
      schema["properties"]["scale"] = number_schema(rule.range);
      schema["properties"]["bias"] = number_schema(rule.range);
      return schema;
    }
    default:
      return type_schema(rule);
  }
}

// A key that several methods have in different ranges may have any value that one of them permits. Where the file
// itself names the method, only that method's ranges and keys hold.
void add_methods(OrderedJson& root, std::span<const MethodInfo> methods) {
  OrderedJson& render = root["properties"]["render"];
  std::map<std::string, OrderedJson> variants;
  std::map<std::string, std::string> meanings;
  OrderedJson names = OrderedJson::array();
  for (const MethodInfo& method : methods) {
    names.push_back(method.name);
    for (const ParameterInfo& parameter : method.parameters) {
      const std::string key(parameter.key);
      const OrderedJson schema = parameter_schema(parameter);
      OrderedJson& known = variants[key];
      if (std::ranges::find(known, schema) == known.end()) {
        known.push_back(schema);
      }
      meanings.emplace(key, parameter.meaning);
    }
  }
  for (const auto& [key, known] : variants) {
    OrderedJson property = known.size() == 1 ? known[0] : OrderedJson{{"anyOf", known}};
    property["description"] = meanings[key];
    render["properties"][key] = property;
  }
  render["properties"]["method"].erase("type");
  render["properties"]["method"]["enum"] = names;
  for (const MethodInfo& method : methods) {
    OrderedJson own = OrderedJson::object();
    for (const auto& [key, known] : variants) {
      own[key] = false;
    }
    for (const ParameterInfo& parameter : method.parameters) {
      own[std::string(parameter.key)] = parameter_schema(parameter);
    }
    render["allOf"].push_back(
        {{"if", {{"properties", {{"method", {{"const", method.name}}}}}, {"required", {"method"}}}},
         {"then", {{"properties", own}}}});
  }
}

}  // namespace

std::string json_schema(std::span<const MethodInfo> methods) {
  OrderedJson root = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "airlight preset, format 1"},
                      {"description", "Made from the rules in core/scene/rule_table.cpp and the methods' own lists."},
                      {"type", "object"},
                      {"properties", OrderedJson::object()},
                      {"additionalProperties", false},
                      {"anyOf", {{{"required", {"airlight", "media"}}}, {{"required", {"extends"}}}}}};
  for (const Rule& rule : rules()) {
    OrderedJson& property = owner_of(root, rule.key)["properties"][last_part(rule.key)];
    if (property.is_null()) {
      property = annotated(type_schema(widest(rule)), rule);
    }
  }
  root["properties"]["media"]["items"]["required"] = {"name"};
  root["properties"]["scene"]["properties"]["spheres"]["items"]["required"] = {"distance_m", "radius_m"};
  for (const Rule& rule : rules()) {
    if (rule.type == RuleType::choice) {
      const std::string prefix(rule.key.substr(0, rule.key.rfind('.') + 1));
      if (std::ranges::any_of(rules(), [&](const Rule& other) {
            return !other.only_for.empty() && other.key.starts_with(prefix) && prefix.size() > 1;
          })) {
        add_choice(root, rule);
      }
    }
  }
  add_tilt(root);
  add_key_frames(root);
  add_methods(root, methods);
  return root.dump(2) + "\n";
}

}  // namespace airlight::test
