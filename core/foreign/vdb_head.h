#pragma once
// The head of an OpenVDB file: which grids it holds, and whether it is as long as it says. OpenVDB's library gives
// zeros for what is missing, and OpenImageIO does not tell of grids that it cannot read.

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::foreign {

struct VdbGrid {
  std::string name;
  bool real = false;  // of one floating-point number a voxel
};

// The grids in the file's order. Throws std::runtime_error with a reason that continues "FILE: ": it is no OpenVDB
// file, older than version 222 (OpenVDB 2.2, 2013), or damaged or cut short.
std::vector<VdbGrid> vdb_grids(const std::filesystem::path& file);

}  // namespace airlight::foreign
