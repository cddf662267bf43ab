#pragma once
// Every command of the tool: one function and one line in main.cpp each.

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
// These describe the whole tool, which must outlive them; help those commands that the tool has by then.
Command help_command(const Tool& tool);
Command completion_command(const Tool& tool);
Command man_command(const Tool& tool);

// "  NAME VERSION" lines of the libraries that the program was built with.
std::string library_versions();

}  // namespace airlight::cli
