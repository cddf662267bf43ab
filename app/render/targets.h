#pragma once
// Which files a render writes.

#include "app/render/publish.h"
#include "app/render/run.h"

namespace airlight::cli {

// The files that the options name; without any, an EXR and a PNG of the preset's name in the folder out.
Targets choose_targets(const RenderOrder& given);

// Everything about them that can be known to fail is said before anything is rendered. Throws InputError.
void check_targets(const RenderOrder& given, const Targets& targets);

}  // namespace airlight::cli
