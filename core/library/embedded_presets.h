#pragma once
// The files of presets/, embedded at build time by embed_presets.cmake.

#include <string_view>

#include "core/scene/preset.h"

namespace airlight {

const BundledPresets& embedded_presets();  // "earth-noon.json" -> text

std::string_view embedded_chart_list();  // chart.json

}  // namespace airlight
