#pragma once
// Another program, run and waited for.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace airlight::cli {

struct ProcessResult {
  int exit_code = 0;   // 128 + its number for a signal
  std::string errors;  // what it wrote to standard error
};

// `words`: the program, looked for on PATH, and its arguments; `folder`: where it runs. Nothing when there is no such
// program. Throws RunError when it cannot be started for another reason.
std::optional<ProcessResult> run_process(const std::filesystem::path& folder, const std::vector<std::string>& words);

}  // namespace airlight::cli
