#pragma once
// Several files replaced together: all of them or none.

#include <filesystem>
#include <vector>

namespace airlight {

struct Replacement {
  std::filesystem::path from;  // is read and stays
  std::filesystem::path to;    // exists; keeps its permissions, and a symbolic link stays one
};

// Copies all new contents beside their targets before the first target changes, then renames them in a row; where one
// fails, those before it are put back. SIGINT, SIGTERM and SIGHUP wait: before the renames they end with nothing
// changed, among them with all done. Only a kill or a power cut between two renames leaves some files new and some old,
// each whole. Throws RunError; then every target is as it was.
void replace_files(const std::vector<Replacement>& replacements);

}  // namespace airlight
