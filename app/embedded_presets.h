#pragma once
// The files of presets/, embedded at build time by app/embed_presets.cmake.

#include "core/scene/preset.h"

namespace airlight::cli {

const BundledPresets& embedded_presets();  // "earth-noon.json" -> text

}  // namespace airlight::cli
