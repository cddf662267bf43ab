#include <memory>

#include "app/cli/json_writer.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/gpu/executor.h"

namespace airlight::cli {
namespace {

std::string devices_json() {
  JsonWriter json;
  json.begin_object().key("devices").begin_array();
  for (const DeviceInfo& device : list_devices()) {
    json.begin_object().key("name").value(device.name).key("driver").value(device.driver);
    json.key("vulkan").value(device.api_version).key("is_processor").value(device.is_cpu);
    json.key("usable").value(device.missing.empty()).key("missing").values(device.missing).end_object();
  }
  return json.end_array().end_object().take();
}

}  // namespace

Command devices_command() {
  Command command;
  command.name = "devices";
  command.summary = "List the Vulkan devices, and what an unusable device lacks";
  command.examples = {
      {"airlight devices", "List the devices"},
      {"airlight render earth-noon --device llvmpipe", "Use the first device whose name contains llvmpipe"}};
  const auto json = std::make_shared<bool>(false);
  command.options = {{"--json", "", "Print one JSON object", json.get()}};
  command.run = [json] {
    if (*json) {
      print(devices_json());
      return 0;
    }
    for (const DeviceInfo& device : list_devices()) {
      std::string text = device.name + "\n    Vulkan " + device.api_version + ", " + device.driver + "\n";
      text += std::string("    ") + (device.is_cpu ? "runs on the processor" : "graphics processor");
      text += device.missing.empty() ? ", usable\n" : ", not usable; it lacks:\n";
      for (const std::string& feature : device.missing) {
        text += "        " + feature + "\n";
      }
      print(text);
    }
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
