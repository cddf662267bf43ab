#include <cmath>
#include <memory>

#include "app/cli/json_writer.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/render_settings.h"
#include "core/scene/thing_kinds.h"

namespace airlight::cli {
namespace {

std::string value_text(const ParameterValue& value) {
  const auto* word = std::get_if<std::string>(&value);
  const std::string text = word != nullptr ? *word : json_text(value);
  return text.empty() ? "absent" : text;
}

std::string limits_text(const ParameterInfo& parameter) {
  const auto range = [&] {
    return std::isinf(parameter.maximum) ? "at least " + format_number(parameter.minimum)
                                         : format_number(parameter.minimum) + " to " + format_number(parameter.maximum);
  };
  switch (parameter.kind) {
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::integer:
      return "whole number, " + range();
    case ParameterKind::number:
      return "number, " + range();
    case ParameterKind::table_size:
      return "[width, height], each " + range();
    case ParameterKind::sun_fade:
      return "{\"scale\", \"bias\"}";
    case ParameterKind::choice:
      break;
  }
  return joined(parameter.choices);
}

std::string validity_text(const Validity& validity) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (validity.sun_elevation_min > -1.57) {
    add("sun above " + format_number(degrees_from_radians(validity.sun_elevation_min)) + " deg");
  }
  if (validity.altitude_max < 1e9) {
    add("camera below " + format_number(validity.altitude_max) + " km");
  }
  if (validity.optical_depth_max < 1e9) {
    add("vertical optical depth below " + format_number(validity.optical_depth_max));
  }
  return text.empty() ? "any sun, height and air" : text;
}

std::string refused_things(const MethodInfo& method) {
  return joined_of(kThingKinds,
                   [&](const ThingKind& kind) { return method.*kind.known ? std::string_view() : kind.name; });
}

void print_method(const SkyMethod& method) {
  std::string text = std::string(method.info.name) + "\n    " + std::string(method.info.summary) + "\n";
  text +=
      "    runs on: " + std::string(method.render_on_host != nullptr ? "the processor" : "the Vulkan device") + "\n";
  text += "    holds for: " + validity_text(method.validity) + "\n";
  if (const std::string refused = refused_things(method.info); !refused.empty()) {
    text += "    refuses: " + refused + "\n";
  }
  if (!method.validity.leaves_out.empty()) {
    text += "    leaves out: " + std::string(method.validity.leaves_out) + "\n";
  }
  for (const ParameterInfo& parameter : method.info.parameters) {
    text += "    render." + std::string(parameter.key) + " (" + limits_text(parameter) + "; default " +
            value_text(parameter.default_value) + ")\n        " + std::string(parameter.meaning) + "\n";
  }
  print(text);
}

std::string methods_json() {
  JsonWriter json;
  json.begin_object().key("methods").begin_array();
  for (const SkyMethod& method : methods()) {
    json.begin_object().key("name").value(method.info.name).key("summary").value(method.info.summary);
    json.key("runs_on").value(method.render_on_host != nullptr ? "processor" : "device");
    json.key("holds_for").value(validity_text(method.validity)).key("leaves_out").value(method.validity.leaves_out);
    json.key("refuses").value(refused_things(method.info));
    json.key("parameters").begin_array();
    for (const ParameterInfo& parameter : method.info.parameters) {
      json.begin_object().key("key").value(parameter.key).key("takes").value(limits_text(parameter));
      json.key("default").value(value_text(parameter.default_value)).key("meaning").value(parameter.meaning);
      json.end_object();
    }
    json.end_array().end_object();
  }
  return json.end_array().end_object().take();
}

}  // namespace

Command methods_command() {
  Command command;
  command.name = "methods";
  command.summary = "List the rendering methods, the scenes that each holds for, and its keys under render";
  command.examples = {{"airlight methods", "List the methods"}};
  const auto json = std::make_shared<bool>(false);
  command.options = {{"--json", "", "Print one JSON object", json.get()}};
  command.run = [json] {
    if (*json) {
      print(methods_json());
      return 0;
    }
    for (const SkyMethod& method : methods()) {
      print_method(method);
    }
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
