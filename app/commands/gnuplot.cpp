#include "app/commands/gnuplot.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <functional>

#include "app/cli/process.h"
#include "core/base/error.h"
#include "core/base/file_descriptor.h"
#include "core/output/ending.h"

namespace airlight::cli {
namespace {

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return text;
    }
  }
}

}  // namespace

std::vector<std::string> plot(const std::string& command, const std::filesystem::path& folder,
                              const std::string& script, const std::string& prefix,
                              const std::vector<std::string>& endings) {
  namespace fs = std::filesystem;
  const std::string part = "plot-" + std::to_string(std::hash<std::string>{}(folder.string())) + ".part" + prefix;
  std::vector<fs::path> parts;
  for (const std::string& ending : endings) {
    parts.push_back(folder / (part + ending));
  }
  FilesOfAnother drawn(parts);
  std::array<int, 2> errors{};
  if (::pipe2(errors.data(), O_CLOEXEC) != 0) {
    throw RunError(command + ": gnuplot cannot be started: " + std::strerror(errno));
  }
  const FileDescriptor output(errors[0]);
  FileDescriptor input(errors[1]);
  const pid_t gnuplot = drawn.started_by([&] {
    return start_process({"gnuplot", "-e", "out='" + part + "'", script}, {.folder = folder, .errors = input.get()});
  });
  input.close();
  if (gnuplot == 0) {
    throw RunError(command +
                   ": there is no gnuplot on this machine, so no picture is drawn; on Debian install it with 'apt-get "
                   "install gnuplot-nox', then run 'gnuplot " +
                   script + "' in " + folder.string());
  }
  const std::string messages = read_all(output.get());
  wait_until_ended(gnuplot);
  drawn.ended();
  const int exit_code = exit_code_of(gnuplot);
  std::vector<std::string> written;
  for (std::size_t i = 0; i < endings.size() && exit_code == 0; ++i) {
    const fs::path file = folder / (prefix + endings[i]);
    if (drawn.rename(i, file)) {
      written.push_back(file.string());
    }
  }
  if (written.size() != endings.size()) {
    const std::string said = messages.substr(0, messages.find_last_not_of(" \n") + 1);
    throw RunError(command + ": gnuplot could not draw " + (folder / script).string() + ": " +
                   (said.empty() ? "it wrote no picture" : said.substr(said.find_last_of('\n') + 1)));
  }
  return written;
}

}  // namespace airlight::cli
