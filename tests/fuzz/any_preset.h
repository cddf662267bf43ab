#pragma once
// Presets anywhere within the documented ranges: the table of rules and the methods' own lists say what there is, so
// that a key that is new to them is tried as well.

#include <string>

#include "tests/fuzz/random.h"

namespace airlight::fuzz {

// JSON text. Each number is within its range, mostly near what is usual, often anywhere in it, sometimes at its end;
// tables, steps and samples stay small. Whether all of them together make a scene is resolve()'s to say.
std::string any_preset(Random& random);

}  // namespace airlight::fuzz
