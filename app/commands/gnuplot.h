#pragma once
// Runs gnuplot on a script in a folder.

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::cli {

// Runs `script` in `folder` with `out` set to `prefix` after a name of this run's own, then renames the pictures to
// `prefix` with each of `endings`. Returns these names. Throws RunError, `command` first, when gnuplot is missing (says
// how to get it) or fails; then no picture is new.
std::vector<std::string> plot(const std::string& command, const std::filesystem::path& folder,
                              const std::string& script, const std::string& prefix,
                              const std::vector<std::string>& endings);

}  // namespace airlight::cli
