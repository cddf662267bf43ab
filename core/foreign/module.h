#pragma once
// Loads the module that links OpenImageIO. Linked into the program, that library would cost every start 0.2 CPU-s and
// 130 MB.

namespace airlight::foreign {

// An entry of the module, which is loaded from beside the running program, else from the installed place
// (../lib/airlight/modules from there), once for the life of the process. Throws RunError when the module or the entry
// is missing, or the module does not load.
void* module_entry(const char* name);

}  // namespace airlight::foreign
