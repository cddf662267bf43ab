#include "app/cli/seekable_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace airlight::cli {
namespace {

[[noreturn]] void fail(const std::string& name, const char* doing) {
  throw InputError(name + ": cannot be " + doing + ": " + std::strerror(errno));
}

bool is_stream(const std::string& name) {
  struct stat status = {};
  return name == "-" || (::stat(name.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)));
}

// A copy of all that a descriptor yields, in a file without a name.
FileDescriptor copy_of(int from, const std::string& name) {
  FileDescriptor copy(::memfd_create("airlight", MFD_CLOEXEC));
  if (!copy) fail(name, "copied");
  std::vector<std::byte> buffer(std::size_t{1} << 20U);
  for (;;) {
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(name, "read");
    if (count == 0) return copy;
    if (!write_all(copy.get(), std::span(buffer).first(static_cast<std::size_t>(count)))) fail(name, "copied");
  }
}

}  // namespace

SeekableFile::SeekableFile(const std::string& name) : name_(name == "-" ? "standard input" : name), path_(name) {
  if (!is_stream(name)) {
    return;
  }
  const FileDescriptor from(name == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                        : ::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  if (!from) fail(name_, "opened");
  copy_ = copy_of(from.get(), name_);
  path_ = "/proc/self/fd/" + std::to_string(copy_.get());
}

std::string SeekableFile::told(std::string text) const {
  for (std::size_t at = 0; path_ != name_ && (at = text.find(path_, at)) != std::string::npos; at += name_.size()) {
    text.replace(at, path_.size(), name_);
  }
  return text;
}

}  // namespace airlight::cli
