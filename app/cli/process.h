#pragma once
// Other programs, started and waited for.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::cli {

struct ProcessOptions {
  std::filesystem::path folder = ".";  // where it runs
  int input = -1;                      // its streams; -1: nothing
  int output = -1;
  int errors = -1;
  bool apart = false;  // Ctrl-C does not reach it
};

// `words`: the program, looked for on PATH, and its arguments. Returns its number, or 0 when there is no such program.
// Throws RunError when it cannot be started for another reason.
pid_t start_process(const std::vector<std::string>& words, const ProcessOptions& options);

// Waits for its end, but leaves its exit code, and with it its number, to exit_code_of().
void wait_until_ended(pid_t process);

// Waits for its end: the exit code, 128 + its number for a signal.
int exit_code_of(pid_t process);

}  // namespace airlight::cli
