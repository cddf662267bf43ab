#pragma once
// The preset inside a picture. Somebody else may have written it, so the files that it names are not opened at its
// word.

#include <filesystem>
#include <string>

#include "core/output/provenance.h"
#include "core/scene/preset.h"

namespace airlight::cli {

// `folder`: the picture's. Unless `any_file`, the preset may name built-in presets and files in that folder or below it
// alone. Throws InputError: another file, with the place and --allow-files as the remedy; any error in reading the
// preset.
Preset carried_preset(const Provenance& picture, const std::string& name, const std::filesystem::path& folder,
                      bool any_file);

}  // namespace airlight::cli
