#pragma once
// Cases of files that presets and options name.

#include <cstdint>
#include <filesystem>

#include "tests/fuzz/cases.h"

namespace airlight::fuzz {

// A valid preset with names of files put into it: good ones, bad ones, a pipe, a device, a folder, names of nothing. It
// is refused by a short message, or it is a scene.
Outcome file_case(std::uint64_t seed, const std::filesystem::path& folder);

// A PNG, a TIFF, a Radiance picture, an EXR or a deep EXR with changed bytes, read as a plate and as each kind of map;
// some go through `composite`.
Outcome plate_case(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace airlight::fuzz
