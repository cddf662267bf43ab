#pragma once
// gnuplot run on a script in a folder.

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::cli {

// Runs `script` in `folder` with `out` set to `prefix` behind a name of this run's own, and gives the pictures that it
// writes, `prefix` with each of `endings`, their names. Returns these. Throws RunError, `command` first, when gnuplot
// is missing (says how to get it) or fails; then no picture is there anew.
std::vector<std::string> plot(const std::string& command, const std::filesystem::path& folder,
                              const std::string& script, const std::string& prefix,
                              const std::vector<std::string>& endings);

}  // namespace airlight::cli
