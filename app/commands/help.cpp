#include <algorithm>
#include <memory>

#include "app/cli/suggest.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/error.h"

namespace airlight::cli {

Command help_command(const Tool& tool) {
  const auto name = std::make_shared<std::optional<std::string>>();
  std::vector<std::string> names;
  for (const Command& command : tool.commands) {
    names.push_back(command.name);
  }
  Command command;
  command.name = "help";
  command.summary = "Explain the tool or a command";
  command.examples = {{"airlight help render", "Everything that render takes"}};
  command.positionals = {{.metavar = "COMMAND",
                          .help = "the command to explain",
                          .target = name.get(),
                          .required = false,
                          .completes = Completes::nothing,
                          .offers = names}};
  command.run = [name, names, &tool] {
    const bool bold = colour_on_stdout();
    if (!*name) {
      print(help_text(tool, bold));
      return 0;
    }
    const auto found = std::find_if(tool.commands.begin(), tool.commands.end(),
                                    [&](const Command& candidate) { return candidate.name == **name; });
    if (found == tool.commands.end()) {
      throw InputError("help: no command '" + **name + "'" + did_you_mean(**name, names) + "; '" + tool.name +
                       " help' lists the commands");
    }
    print(help_text(tool, *found, bold));
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
