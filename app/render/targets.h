#pragma once
// The files that a render writes.

#include <memory>

#include "app/render/publish.h"
#include "app/render/run.h"
#include "app/render/table_files.h"

namespace airlight::cli {

// Throws InputError where the picture cannot stand in the format that -o names, or an option is not for that format.
void require_format(const RenderOrder& given, const Scene& scene, const Targets& targets);

// The files that the options name; by default an EXR and a PNG of the preset's name in the folder out.
Targets choose_targets(const RenderOrder& given);

// Checks them for everything that can be known to fail before rendering. Throws InputError. Returns the folder out if
// the files stand there by default.
std::unique_ptr<MadeFolder> check_targets(const RenderOrder& given, const Targets& targets);

}  // namespace airlight::cli
