#pragma once
// The pictures that are checked: every method of the device in every scene, as radiance and as the display shows it.

#include "core/gpu/executor.h"
#include "tests/bench/checksums.h"

namespace airlight::bench {

// "SCENE" holds sky and disc, "SCENE/display" what bloom and the tone curve make of them at automatic exposure. Throws
// RunError for a picture or a table with a NaN, an infinity or a negative value.
Checksums render_checked_pictures(Executor& executor);

}  // namespace airlight::bench
