#include "app/cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/base/error.h"
#include "core/scene/printable.h"

namespace airlight::cli {
namespace {

int first_stdout_error = 0;

// The most bytes of a message: a path may have 4096 of its own.
constexpr std::size_t kLongestLine = 6000;

bool wants_colour(int descriptor) {
  const char* no_colour = std::getenv("NO_COLOR");  // no-color.org: set and not empty means none
  const char* terminal = std::getenv("TERM");
  const bool refused = no_colour != nullptr && *no_colour != '\0';
  const bool dumb = terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
  return !refused && !dumb && isatty(descriptor) == 1;
}

}  // namespace

bool colour_on_stdout() {
  return wants_colour(STDOUT_FILENO);
}

bool colour_on_stderr() {
  return wants_colour(STDERR_FILENO);
}

bool stdout_is_terminal() {
  return isatty(STDOUT_FILENO) == 1;
}

std::size_t line_width() {
  constexpr std::size_t kUsual = 80;
  constexpr std::size_t kNarrowest = 40;
  constexpr std::size_t kWidest = 120;
  winsize size{};
  const bool known = stdout_is_terminal() && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::clamp<std::size_t>(size.ws_col, kNarrowest, kWidest) : kUsual;
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && first_stdout_error == 0) {
    first_stdout_error = errno;
  }
}

void flush_stdout() {
  if (std::fflush(stdout) != 0 && first_stdout_error == 0) {
    first_stdout_error = errno;
  }
}

void complain(std::string_view lines) {
  const std::string prefix = colour_on_stderr() ? "\033[1;31mairlight:\033[0m " : "airlight: ";
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    text += prefix + printable(shortened(lines.substr(0, end), kLongestLine)) + "\n";
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
  }
  tell(text);
}

void complain(const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  complain(input != nullptr && input->has_lines ? std::string(error.what()) : printable(error.what()));
}

void tell(std::string_view text) {
  // If this write fails there is nobody left to tell.
  (void)!std::fwrite(text.data(), 1, text.size(), stderr);
}

void ignore_broken_pipes() {
  std::signal(SIGPIPE, SIG_IGN);
}

void finish_stdout() {
  flush_stdout();
  if (first_stdout_error != 0 && first_stdout_error != EPIPE) {
    throw RunError(std::string("cannot write standard output: ") + std::strerror(first_stdout_error));
  }
}

}  // namespace airlight::cli
