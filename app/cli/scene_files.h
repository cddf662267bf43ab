#pragma once
// Turns a preset into a scene, with the contents of the files that it names.

#include "core/scene/preset.h"

namespace airlight::cli {

// core/library/judged.h with pictures of all formats.
Scene judged(const Preset& preset, const Scene* like = nullptr);

}  // namespace airlight::cli
