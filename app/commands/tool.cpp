// Commands about the tool itself.
#include <algorithm>
#include <memory>

#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/error.h"

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
  command.examples = {{"airlight help render", "Explain render and all its options"}};
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
    const auto found =
        std::ranges::find_if(tool.commands, [&](const Command& candidate) { return candidate.name == **name; });
    if (found == tool.commands.end()) {
      throw InputError("help: no command '" + **name + "'" + did_you_mean(**name, names) + "; '" + tool.name +
                       " help' lists the commands");
    }
    print(help_text(tool, *found, bold));
    return 0;
  };
  return command;
}

Command completion_command(const Tool& tool) {
  const auto shell = std::make_shared<std::string>();
  Command command;
  command.name = "completion";
  command.summary = "Print a completion script for a shell";
  command.description =
      "The script completes commands, options, methods, presets and files. Load it from the shell's start file, or put "
      "it where the shell looks for completions.";
  command.examples = {
      {"source <(airlight completion bash)", "bash: complete airlight in this shell"},
      {"airlight completion zsh > ~/.zfunc/_airlight", "zsh: in a folder that is on $fpath before compinit runs"},
      {"airlight completion fish > ~/.config/fish/completions/airlight.fish", "fish: for every shell from now on"}};
  command.positionals = {
      {"SHELL", "bash, zsh or fish", shell.get(), true, Completes::nothing, {"bash", "zsh", "fish"}, {}}};
  command.run = [shell, &tool] {
    print(completion_script(tool, *shell));
    return 0;
  };
  return command;
}

Command man_command(const Tool& tool) {
  Command command;
  command.name = "man";
  command.summary = "Print the manual page";
  command.examples = {{"airlight man > airlight.1", "Write the manual page; 'man -l airlight.1' shows it"}};
  command.run = [&tool] {
    print(manual_page(tool));
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
