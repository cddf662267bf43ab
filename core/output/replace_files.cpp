#include "core/output/replace_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>
#include <string>

#include "core/base/error.h"
#include "core/base/file_descriptor.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const char* doing) {
  throw RunError(file.string() + ": cannot " + doing + ": " + std::strerror(errno) + "; nothing was replaced");
}

// Holds back the signals that would end the process half way.
class SignalsWait {
 public:
  SignalsWait() {
    sigemptyset(&ending_);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending_, number);
    ::pthread_sigmask(SIG_BLOCK, &ending_, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  bool one_came() const {
    sigset_t pending;
    ::sigpending(&pending);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      if (sigismember(&pending, number) == 1 && sigismember(&before_, number) == 0) return true;
    }
    return false;
  }

 private:
  sigset_t ending_{};
  sigset_t before_{};
};

// Folders beside the targets, one for each target folder; they are removed with all that is in them.
class Staging {
 public:
  Staging() = default;
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    for (const auto& [folder, staging] : folders_) fs::remove_all(staging, ignored);
  }

  fs::path beside(const fs::path& target) {
    const fs::path folder = target.parent_path();
    if (const auto found = folders_.find(folder); found != folders_.end()) return found->second;
    std::string name = (folder / ".airlight-update-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) fail(folder, "make a folder in it");
    return folders_.emplace(folder, name).first->second;
  }

 private:
  std::map<fs::path, fs::path> folders_;
};

// The copy gets the permissions of `target` and is on the disk when the function returns.
void copy_file(const fs::path& from, const fs::path& staged, const fs::path& target) {
  struct stat status = {};
  if (::stat(target.c_str(), &status) != 0) fail(target, "read");
  const FileDescriptor in(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.get() < 0) fail(from, "open");
  const FileDescriptor out(::open(staged.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (out.get() < 0) fail(target, "write beside it");
  std::vector<std::byte> buffer(std::size_t{1} << 20U);
  for (;;) {
    const ssize_t count = ::read(in.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(from, "read");
    if (count == 0) break;
    if (!write_all(out.get(), std::span(buffer).first(static_cast<std::size_t>(count)))) fail(target, "write");
  }
  if (::fchmod(out.get(), status.st_mode & 07777) != 0) fail(target, "keep the permissions");
  if (::fsync(out.get()) != 0) fail(target, "write");
}

struct Staged {
  fs::path target;
  fs::path fresh;
  fs::path old;  // a second name of the target's file, or a copy where second names are impossible
};

void put_back(const std::vector<Staged>& files, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) ::rename(files[i].old.c_str(), files[i].target.c_str());
}

}  // namespace

void replace_files(const std::vector<Replacement>& replacements) {
  const SignalsWait signals;
  Staging staging;
  std::vector<Staged> files;
  for (const Replacement& replacement : replacements) {
    // The signal itself is delivered when `signals` ends.
    if (signals.one_came()) throw RunError(replacement.to.string() + ": interrupted; nothing was replaced");
    std::error_code problem;
    const fs::path target = fs::canonical(replacement.to, problem);
    if (problem) throw RunError(replacement.to.string() + ": " + problem.message() + "; nothing was replaced");
    const fs::path folder = staging.beside(target);
    const std::string number = std::to_string(files.size());
    files.push_back({target, folder / (number + ".new"), folder / (number + ".old")});
    copy_file(replacement.from, files.back().fresh, target);
    if (::link(target.c_str(), files.back().old.c_str()) != 0) copy_file(target, files.back().old, target);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (::rename(files[i].fresh.c_str(), files[i].target.c_str()) != 0) {
      const int reason = errno;
      put_back(files, i);
      errno = reason;
      fail(files[i].target, "replace it");
    }
  }
}

}  // namespace airlight
