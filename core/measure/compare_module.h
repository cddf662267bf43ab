#pragma once
// Loads the module that compares.

#include "core/measure/compare.h"

namespace airlight::measure {

// Looks beside the running program, then where both are installed (../lib/airlight/modules from there). Loaded once,
// kept for the life of the process. Throws RunError when it is missing or does not load.
CompareFunction load_compare();

// Any entry of the same module, loaded likewise.
void* module_entry(const char* name);

}  // namespace airlight::measure
