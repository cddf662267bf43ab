#include "app/cli/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace airlight::cli {
namespace {

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return text;
    }
  }
}

// In the child: never returns. What goes wrong before the program starts is sent as errno.
[[noreturn]] void become(const std::string& folder, const std::vector<char*>& words, int errors, int failure) {
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (chdir(folder.c_str()) == 0) {
    execvp(words.front(), words.data());
  }
  const int problem = errno;
  [[maybe_unused]] const ssize_t sent = write(failure, &problem, sizeof problem);
  _exit(127);
}

}  // namespace

std::optional<ProcessResult> run_process(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const std::string where = folder.string();
  std::array<int, 2> errors{};
  std::array<int, 2> failure{};
  if (pipe2(errors.data(), O_CLOEXEC) != 0 || pipe2(failure.data(), O_CLOEXEC) != 0) {
    throw RunError(words.front() + ": cannot be started: " + std::strerror(errno));
  }
  const pid_t child = fork();
  if (child == 0) {
    become(where, pointers, errors[1], failure[1]);
  }
  const int fork_error = errno;
  close(errors[1]);
  close(failure[1]);
  ProcessResult result;
  std::string problem;
  if (child > 0) {
    result.errors = read_all(errors[0]);
    problem = read_all(failure[0]);
  }
  close(errors[0]);
  close(failure[0]);
  if (child < 0) {
    throw RunError(words.front() + ": cannot be started: " + std::strerror(fork_error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (problem.size() == sizeof(int)) {
    int number = 0;
    std::memcpy(&number, problem.data(), sizeof number);
    if (number == ENOENT) {
      return std::nullopt;
    }
    throw RunError(words.front() + ": cannot be started: " + std::strerror(number));
  }
  result.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return result;
}

}  // namespace airlight::cli
