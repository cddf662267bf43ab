#pragma once
// A preset judged, with what the files hold that it names.

#include "core/scene/preset.h"

namespace airlight::cli {

// Throws InputError: all that is wrong with the preset; else a file that is missing, no picture, too large or not
// finite; else a camera inside the terrain.
Scene judged(const Preset& preset);

}  // namespace airlight::cli
