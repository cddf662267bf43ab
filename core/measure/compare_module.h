#pragma once
// Loads the module that compares.

#include "core/measure/compare.h"

namespace airlight::measure {

// Loads the module from beside the running program, else from the installed place (../lib/airlight/modules from there),
// once for the life of the process. Throws RunError when it is missing or does not load.
CompareFunction load_compare();

// Any entry of the same module, which is loaded in the same way.
void* module_entry(const char* name);

}  // namespace airlight::measure
