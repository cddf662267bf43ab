#pragma once
// The built-in presets by name.

#include <string>
#include <vector>

#include "core/scene/preset.h"

namespace airlight {

// In order, without ".json".
std::vector<std::string> built_in_names();

bool is_built_in(const std::string& name);

// Throws InputError for an unknown name, and names the nearest. `listed_by`: what lists them, for that message.
Preset built_in_preset(const std::string& name, const std::string& listed_by);

// " (did you mean 'NAME'?)" by the nearest name; empty when none is near.
std::string suggested(const std::string& word, const std::vector<std::string>& names);

}  // namespace airlight
