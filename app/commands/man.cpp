#include "app/cli/terminal.h"
#include "app/commands/commands.h"

namespace airlight::cli {

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
