#include <algorithm>
#include <memory>

#include "app/cli/json_writer.h"
#include "app/cli/preset_source.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/library/built_in.h"
#include "core/methods/method.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

void list_presets() {
  std::size_t width = 0;
  for (const std::string& name : built_in_names()) {
    width = std::max(width, name.size());
  }
  for (const std::string& name : built_in_names()) {
    const Scene scene = resolve(find_preset(name), method_infos());
    print(name + std::string(width + 2 - name.size(), ' ') + scene.description + "\n");
  }
}

std::string presets_json() {
  JsonWriter json;
  json.begin_object().key("presets").begin_array();
  for (const std::string& name : built_in_names()) {
    const Scene scene = resolve(find_preset(name), method_infos());
    json.begin_object().key("name").value(name).key("description").value(scene.description);
    json.key("method").value(scene.render.method).end_object();
  }
  return json.end_array().end_object().take();
}

void print_preset(const std::string& name) {
  const std::vector<std::string> names = built_in_names();
  if (std::ranges::find(names, name) == names.end()) {
    throw InputError("presets: no built-in preset '" + name + "'" + did_you_mean(name, names) +
                     "; 'airlight presets' lists them");
  }
  print(to_json(resolve(find_preset(name), method_infos())) + "\n");
}

}  // namespace

Command presets_command() {
  const auto name = std::make_shared<std::optional<std::string>>();
  Command command;
  command.name = "presets";
  command.summary = "List the built-in presets, or print one";
  command.description =
      "If you give a name, airlight prints that preset with every key written out. You can start your own preset from "
      "it.";
  command.examples = {{"airlight presets", "List the built-in presets and what they show"},
                      {"airlight presets earth-noon > my-sky.json", "Start a preset of your own"}};
  command.positionals = {
      {"NAME", "a built-in preset to print", name.get(), false, Completes::nothing, {}, built_in_names()}};
  const auto json = std::make_shared<bool>(false);
  command.options = {
      {"--json", "", "Print the list as one JSON object; a preset is always printed as JSON", json.get()}};
  command.run = [name, json] {
    if (!*name && *json) {
      print(presets_json());
    } else if (*name) {
      print_preset(**name);
    } else {
      list_presets();
    }
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
