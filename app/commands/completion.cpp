#include <memory>

#include "app/cli/terminal.h"
#include "app/commands/commands.h"

namespace airlight::cli {

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
      {"airlight completion zsh > ~/.zfunc/_airlight", "zsh: for a folder that is on $fpath before compinit runs"},
      {"airlight completion fish > ~/.config/fish/completions/airlight.fish", "fish: for every shell from now on"}};
  command.positionals = {
      {"SHELL", "bash, zsh or fish", shell.get(), true, Completes::nothing, {"bash", "zsh", "fish"}, {}}};
  command.run = [shell, &tool] {
    print(completion_script(tool, *shell));
    return 0;
  };
  return command;
}

}  // namespace airlight::cli
