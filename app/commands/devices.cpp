#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/gpu/executor.h"

namespace airlight::cli {

Command devices_command() {
  Command command;
  command.name = "devices";
  command.summary = "List the Vulkan devices and what those that cannot be used lack";
  command.examples = {{"airlight devices", "List the devices"},
                      {"airlight render earth-noon --device llvmpipe", "Use the first device of that name"}};
  command.run = [] {
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
