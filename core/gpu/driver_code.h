#pragma once
// Code that the software device's driver compiled when airlight was built.
//
// Mesa compiles each shader when it first runs, which is most of a first start, and keeps the code in a folder of the
// user's, by hashes of shader, driver and processor. The build renders every preset once (driver_code.cmake) and leaves
// what Mesa kept in the folder "driver_code" beside the program. It is not installed: code for another driver or
// processor is of no use, though it does no harm.

#include <filesystem>

namespace airlight {

// Copies what Mesa's folder lacks of the build's code into it, once for each of the two: a note in `cache`, the folder
// for what saves time at later starts, tells. Nothing is copied where `cache` is empty, Mesa keeps nothing
// ($MESA_SHADER_CACHE_DISABLE) or the build left no code. A fault is no error, since only time is lost.
void take_driver_code(const std::filesystem::path& cache);

// Where these renders left the presets' tables (stored_tables.h), beside folders of their buffers and their values
// (kept_values.h); empty: nowhere.
std::filesystem::path built_tables();

}  // namespace airlight
