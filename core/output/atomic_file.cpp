#include "core/output/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_descriptor.h"
#include "core/base/text.h"
#include "core/output/last_words.h"
#include "core/output/temporary.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& file, const char* doing, int error) {
  std::string hint;
  if (error == ENOSPC || error == EDQUOT) {
    hint = "; free some space or write elsewhere";
  } else if (error == EFBIG) {
    hint = "; raise the limit on the size of files (ulimit -f) or write elsewhere";
  } else if (error == EACCES || error == EPERM || error == EROFS) {
    hint = "; write to a folder of your own";
  }
  throw RunError(file + ": cannot " + doing + ": " + std::strerror(error) + hint);
}

// Whether the name is a descriptor of this process. Even a regular file is then the caller's and is not replaced.
bool names_descriptor(const fs::path& file) {
  const std::string name = file.lexically_normal().string();
  return name == "/dev/stdout" || name == "/dev/stderr" || name.starts_with("/dev/fd/") || name.starts_with("/proc/");
}

// A pipe, a device, /dev/stdout: nothing that a rename could replace.
bool is_special(const fs::path& file) {
  struct stat status = {};
  return names_descriptor(file) || (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
}

// The target of a symbolic link, so that the rename replaces the target and not the link.
fs::path behind_links(const fs::path& file) {
  std::error_code error;
  fs::path target = fs::canonical(file, error);
  return error ? file : target;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

constexpr std::size_t kMaxName = 255;  // NAME_MAX of every common file system
constexpr const char* kTemporaryMark = ".part-";

// A name that no other process uses, nor one on another machine that shares the folder.
std::string temporary_name(const fs::path& file) {
  std::array<char, 65> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string suffix = kTemporaryMark + std::string(host.data()) + "-" + std::to_string(::getpid());
  const std::string name = file.filename().string().substr(0, kMaxName - suffix.size());
  return (file.parent_path() / (name + suffix)).string();
}

using Pieces = std::function<std::span<const std::byte>()>;

// All contents as one piece.
Pieces one_piece(std::span<const std::byte> contents) {
  return [contents]() mutable { return std::exchange(contents, {}); };
}

// The descriptor of this process that the name denotes; -1: none.
int descriptor_called(const std::string& name) {
  constexpr std::string_view kFolder = "/dev/fd/";
  if (name == "/dev/stdout" || name == "/dev/stderr") {
    return name == "/dev/stdout" ? STDOUT_FILENO : STDERR_FILENO;
  }
  return name.starts_with(kFolder) ? number_from<int>(name.substr(kFolder.size())).value_or(-1) : -1;
}

// An open descriptor is written from its current position. Opened by its name, a file that the shell appends to would
// be emptied, and a socket could not be opened at all.
int open_in_place(const std::string& file) {
  const int descriptor = descriptor_called(fs::path(file).lexically_normal().string());
  const int fd = descriptor >= 0 ? ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)
                                 : ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) {
    fail(file, "open", errno);
  }
  return fd;
}

}  // namespace

void require_writable(const fs::path& file) {
  const std::string name = file.string();
  if (name.empty()) {
    throw InputError("output file: the name is empty; give one such as sky.exr");
  }
  struct stat status = {};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    throw InputError(name + ": is a directory; name a file in it, such as " + (file / "sky.exr").string());
  }
  if (!file.has_filename()) {
    throw InputError(name + ": names a directory, not a file; create it and name a file in it");
  }
  if (exists && ::access(file.c_str(), W_OK) != 0) {
    throw InputError(name + ": cannot be written (" + std::strerror(errno) +
                     "); make it writable or choose another file");
  }
  if (is_special(file)) {
    return;
  }
  const fs::path folder = folder_of(behind_links(file));
  if (::stat(folder.c_str(), &status) != 0) {
    const int reason = errno;
    if (reason == ENOENT) {
      throw InputError(name + ": the directory " + folder.string() + " does not exist; create it with: mkdir -p " +
                       folder.string());
    }
    throw InputError(name + ": the directory " + folder.string() + " cannot be reached (" + std::strerror(reason) +
                     "); choose another");
  }
  if (!S_ISDIR(status.st_mode)) {
    throw InputError(name + ": " + folder.string() + " is a file, not a directory; choose another place");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError(name + ": the directory " + folder.string() + " cannot be written (" + std::strerror(errno) +
                     "); choose a folder of your own");
  }
}

void write_file(const fs::path& file, std::span<const std::byte> contents) {
  write_file(file, one_piece(contents));
}

void write_file(const fs::path& file, const Pieces& next) {
  FileInProgress out(file, FileInProgress::Order::onward);
  std::uint64_t position = 0;
  for (std::span<const std::byte> piece = next(); !piece.empty(); piece = next()) {
    out.write(position, piece);
    position += piece.size();
  }
  out.commit();
}

struct FileInProgress::State {
  // Writes in place where there is no target that a rename could replace, at once unless `late`.
  State(std::string name_given, const fs::path& target_file, bool in_place, bool late)
      : name(std::move(name_given)), target(target_file) {
    if (!in_place) {
      temporary.emplace(temporary_name(target));
      out.emplace(open_new(temporary->path(), name));
    } else if (!late) {
      out.emplace(open_in_place(name));
    }
  }

  // A killed process with the same number may have left `path`.
  static int open_new(const char* path, const std::string& name) {
    ::unlink(path);
    const int fd = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0) {
      fail(name, "create", errno);
    }
    return fd;
  }

  std::string name;
  fs::path target;
  std::optional<Temporary> temporary;
  std::optional<FileDescriptor> out;
  std::vector<std::byte> held;  // of a target that is not open yet
  int error = 0;                // of the first write that failed
};

FileInProgress::FileInProgress(const fs::path& file, Order order) {
  const std::string name = file.string();
  const bool in_place = is_special(file);
  if (in_place && order == Order::any) {
    throw InputError(name + ": a picture in tiles needs a file in which one can go back; name one, such as sky.exr");
  }
  state_ = std::make_unique<State>(name, in_place ? file : behind_links(file), in_place, order == Order::held);
  if (in_place) {
    return;
  }
  (void)::flock(state_->out->get(), LOCK_EX | LOCK_NB);  // tells remove_abandoned_files() that a writer is at work
  struct stat older = {};
  if (::stat(state_->target.c_str(), &older) == 0 && ::fchmod(state_->out->get(), older.st_mode & 07777) != 0) {
    fail(name, "keep the permissions", errno);
  }
}

FileInProgress::~FileInProgress() = default;

void FileInProgress::write(std::uint64_t position, std::span<const std::byte> contents) {
  if (!state_->out) {
    std::vector<std::byte>& held = state_->held;
    held.resize(std::max(held.size(), static_cast<std::size_t>(position) + contents.size()));
    std::ranges::copy(contents, held.begin() + static_cast<std::ptrdiff_t>(position));
    return;
  }
  if (!state_->temporary) {
    if (!write_all(state_->out->get(), contents)) {
      state_->error = errno;
      fail(state_->name, "write", errno);
    }
    return;
  }
  while (!contents.empty()) {
    const ssize_t count = ::pwrite(state_->out->get(), contents.data(), contents.size(), static_cast<off_t>(position));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      state_->error = errno;
      fail(state_->name, "write", errno);
    }
    contents = contents.subspan(static_cast<std::size_t>(count));
    position += static_cast<std::uint64_t>(count);
  }
}

void FileInProgress::commit() {
  if (!state_->out) {
    state_->out.emplace(open_in_place(state_->name));
    write(0, state_->held);
  }
  if (state_->error != 0) {
    fail(state_->name, "write", state_->error);
  }
  if (state_->temporary && ::fsync(state_->out->get()) != 0) {
    fail(state_->name, "write", errno);
  }
  if (!state_->out->close()) {
    fail(state_->name, "close", errno);
  }
  if (state_->temporary && !state_->temporary->rename_to(state_->target.string())) {
    fail(state_->name, "replace", errno);
  }
  remember_whole(state_->name);
}

void remove_abandoned_files(const fs::path& folder,
                            const std::function<bool(const std::string& name)>& is_target) noexcept {
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      const std::size_t mark = name.rfind(kTemporaryMark);
      if (mark == std::string::npos || !is_target(name.substr(0, mark))) {
        continue;
      }
      const FileDescriptor left(::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
      struct stat status = {};
      // An empty file may be a moment old, before its writer locks it.
      constexpr ::time_t kLongAgo = 600;
      const bool abandoned = left.get() >= 0 && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0 &&
                             ::fstat(left.get(), &status) == 0 &&
                             (status.st_size > 0 || ::time(nullptr) - status.st_mtime > kLongAgo);
      if (abandoned) {
        ::unlink(entry.path().c_str());
      }
    }
  } catch (const std::exception&) {
    return;  // the folder cannot be read, or changed meanwhile
  }
}

void remove_abandoned_files_of(const fs::path& file) noexcept {
  try {
    remove_abandoned_files(folder_of(file), [&](const std::string& name) { return name == file.filename(); });
  } catch (const std::exception&) {
    return;  // out of memory
  }
}

}  // namespace airlight
