#pragma once
// Starts other programs and waits for them.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace airlight::cli {

struct ProcessOptions {
  std::filesystem::path folder = ".";  // its working folder
  int input = -1;                      // its standard streams; -1: none
  int output = -1;
  int errors = -1;
  bool apart = false;  // Ctrl-C does not reach it
};

// `words`: the program, looked up on PATH, and its arguments. Returns the process number, or 0 when there is no such
// program. Throws RunError when it cannot be started for another reason.
pid_t start_process(const std::vector<std::string>& words, const ProcessOptions& options);

// Waits for its end. Its exit code, and with it its number, is left to exit_code_of().
void wait_until_ended(pid_t process);

// Waits for its end. Returns the exit code; 128 + the signal's number if a signal ended it.
int exit_code_of(pid_t process);

}  // namespace airlight::cli
