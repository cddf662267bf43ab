#pragma once
// Every command of the tool: each has one function here and one line in main.cpp.

#include "app/cli/cli.h"

namespace airlight::cli {

Command render_command();
Command sequence_command();
Command luts_command();
Command composite_command();
Command probe_command();
Command check_command();
Command methods_command();
Command devices_command();
Command presets_command();
Command diff_command();
Command chart_command();
Command stability_command();
// Commands that describe the whole tool, which must outlive them. help_command() helps with all commands that the tool
// has when it runs.
Command help_command(const Tool& tool);
Command completion_command(const Tool& tool);
Command man_command(const Tool& tool);

// "  NAME VERSION" lines of the libraries that the program was built with.
std::string library_versions();

}  // namespace airlight::cli
