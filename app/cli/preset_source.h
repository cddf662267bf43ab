#pragma once
// What the user may write where a preset is expected: a file or a pipe that holds a preset, or an EXR or PNG of ours, a
// built-in preset's name, or "-".

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/preset.h"

namespace airlight::cli {

// Throws InputError: no such file or name (with the nearest), a picture without our preset, and whatever reading finds.
Preset find_preset(const std::string& argument);

// The built-in presets' names, in order, without ".json".
std::vector<std::string> built_in_names();

// What a picture of this preset is called unless the user says: the file's or preset's name without folder and ending.
std::string picture_name(const std::string& argument);

}  // namespace airlight::cli
