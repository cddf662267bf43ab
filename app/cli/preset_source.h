#pragma once
// The possible forms of a PRESET argument: a file or a pipe with a preset, an EXR or PNG of ours, a built-in preset's
// name, or "-".

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/cli.h"
#include "core/scene/preset.h"

namespace airlight::cli {

// Throws InputError: no such file or name (with the nearest), a picture without our preset, any error in reading it.
// `any_file`: the preset of a picture may name files anywhere (carried_preset).
Preset find_preset(const std::string& argument, bool any_file = false);

// --allow-files sets it.
Option allow_files_option(bool& any_file);

// Default name of a picture of this preset: the file's or preset's name without folder and ending.
std::string picture_name(const std::string& argument);

}  // namespace airlight::cli
