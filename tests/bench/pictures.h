#pragma once
// The checked pictures: every method of the device in every scene, as radiance and as displayed.

#include "core/gpu/executor.h"
#include "tests/bench/checksums.h"

namespace airlight::bench {

// "SCENE" is the radiance with sky and disc; "SCENE/display" is that with bloom and the tone curve, at automatic
// exposure. Throws RunError for a picture or a table with a NaN, an infinity or a negative value.
Checksums render_checked_pictures(Executor& executor);

}  // namespace airlight::bench
