#pragma once
// Presets anywhere within the documented ranges. The table of rules and the methods' own lists are the source, so that
// a new key is tried as well.

#include <string>

#include "tests/fuzz/random.h"

namespace airlight::fuzz {

// JSON text. Each number is within its range, mostly near a usual value, often anywhere, sometimes at an end; tables,
// steps and samples stay small. Whether the numbers together make a scene is for resolve() to judge.
std::string any_preset(Random& random);

}  // namespace airlight::fuzz
