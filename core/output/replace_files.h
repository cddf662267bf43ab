#pragma once
// Replaces several files together: all of them or none.

#include <filesystem>
#include <vector>

namespace airlight {

struct Replacement {
  std::filesystem::path from;  // read; stays
  std::filesystem::path to;    // exists; keeps its permissions, and a symbolic link stays one
};

// Copies all new contents beside their targets before the first target changes, then renames them in a row. If a rename
// fails, those before it are undone. SIGINT, SIGTERM and SIGHUP wait: before the renames nothing changes, during them
// all is finished. Only a kill or a power cut between two renames leaves some files new and some old, each whole.
// Throws RunError; then every target is as before.
void replace_files(const std::vector<Replacement>& replacements);

}  // namespace airlight
