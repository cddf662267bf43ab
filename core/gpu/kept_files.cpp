#include "core/gpu/kept_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/file_descriptor.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPart = ".part-";
constexpr std::time_t kAbandoned = 600;  // seconds after which a partial file counts as abandoned

struct Header {
  std::array<char, 16> magic{'a', 'i', 'r', 'l', 'i', 'g', 'h', 't', ' ', 'k', 'e', 'p', 't', ' ', ' ', '1'};
  Digest key{};
  Digest contents{};  // of the words
  bool operator==(const Header&) const = default;
};
static_assert(sizeof(Header) == 80 && std::is_trivially_copyable_v<Header>);

std::optional<std::string> environment_value(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

bool is_ours_alone(const struct stat& status) {
  return status.st_uid == ::geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

// No descriptor where the folder does not exist or others may write to it.
FileDescriptor open_folder(const fs::path& folder) {
  if (folder.empty()) return FileDescriptor();
  FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  struct stat status = {};
  if (opened && ::fstat(opened.get(), &status) == 0 && is_ours_alone(status)) return opened;
  return FileDescriptor();
}

void make_folder(const fs::path& folder) {
  if (folder.empty()) return;
  for (const fs::path& level : {folder.parent_path().parent_path(), folder.parent_path(), folder}) {
    ::mkdir(level.c_str(), 0700);
  }
}

bool read_all(int fd, void* target, std::size_t bytes) {
  auto* at = static_cast<char*>(target);
  while (bytes > 0) {
    const ssize_t count = ::read(fd, at, bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += count;
    bytes -= static_cast<std::size_t>(count);
  }
  return true;
}

struct Entry {
  std::string name;
  struct timespec used = {};
  std::uint64_t bytes = 0;
};

bool is_older(const Entry& a, const Entry& b) {
  return a.used.tv_sec != b.used.tv_sec ? a.used.tv_sec < b.used.tv_sec : a.used.tv_nsec < b.used.tv_nsec;
}

// Our files in the folder, except those being written; abandoned partial files are removed.
std::vector<Entry> entries_of(int folder, const std::string& ending) {
  std::vector<Entry> entries;
  const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const std::unique_ptr<DIR, int (*)(DIR*)> listing(again < 0 ? nullptr : ::fdopendir(again), ::closedir);
  if (!listing) return entries;
  for (const dirent* entry = ::readdir(listing.get()); entry != nullptr; entry = ::readdir(listing.get())) {
    const std::string name = entry->d_name;
    const bool is_part = name.find(kPart) != std::string::npos;
    struct stat status = {};
    if ((!is_part && !name.ends_with(ending)) || ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 ||
        !S_ISREG(status.st_mode)) {
      continue;
    }
    if (!is_part) {
      entries.push_back({name, status.st_mtim, static_cast<std::uint64_t>(status.st_size)});
    } else if (std::time(nullptr) - status.st_mtime > kAbandoned) {
      ::unlinkat(folder, name.c_str(), 0);
    }
  }
  return entries;
}

}  // namespace

fs::path user_cache_folder() {
  if (const auto chosen = environment_value("AIRLIGHT_CACHE")) return *chosen == "off" ? fs::path() : fs::path(*chosen);
  const auto cache = environment_value("XDG_CACHE_HOME");
  if (cache && fs::path(*cache).is_absolute()) return fs::path(*cache) / "airlight";
  const auto home = environment_value("HOME");
  if (home && fs::path(*home).is_absolute()) return fs::path(*home) / ".cache" / "airlight";
  return {};
}

std::vector<std::uint32_t> KeptFiles::find(const Digest& key) const {
  const FileDescriptor folder = open_folder(folder_);
  if (!folder) return {};
  const std::string name = hexadecimal(key) + ending_;
  // Opening must not block on a pipe of that name, nor follow a link.
  const FileDescriptor file(::openat(folder.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (!file || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode) || !is_ours_alone(status)) return {};
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size <= sizeof(Header) || size > sizeof(Header) + kWordsMax * sizeof(std::uint32_t) ||
      (size - sizeof(Header)) % sizeof(std::uint32_t) != 0)
    return {};
  Header header;
  std::vector<std::uint32_t> words((size - sizeof(Header)) / sizeof(std::uint32_t));
  if (!read_all(file.get(), &header, sizeof header) ||
      !read_all(file.get(), words.data(), words.size() * sizeof(std::uint32_t))) {
    return {};
  }
  const Header expected{.key = key, .contents = sha256(std::as_bytes(std::span(words)))};
  if (header != expected) return {};
  (void)::futimens(file.get(), nullptr);  // records its last use; fails harmlessly in a read-only folder
  return words;
}

void KeptFiles::keep(const Digest& key, std::span<const std::uint32_t> words) const {
  if (words.size() > kWordsMax) return;
  make_folder(folder_);
  const FileDescriptor folder = open_folder(folder_);
  if (!folder) return;
  static std::atomic<unsigned> count = 0;
  const std::string name = hexadecimal(key) + ending_;
  const std::string part =
      hexadecimal(key) + std::string(kPart) + std::to_string(::getpid()) + "-" + std::to_string(count++);
  ::unlinkat(folder.get(), part.c_str(), 0);  // left by a killed process with the same number
  FileDescriptor file(::openat(folder.get(), part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file) return;
  const Header header{.key = key, .contents = sha256(std::as_bytes(words))};
  const bool written = write_all(file.get(), std::as_bytes(std::span(&header, 1))) &&
                       write_all(file.get(), std::as_bytes(words)) && file.close();
  if (!written || ::renameat(folder.get(), part.c_str(), folder.get(), name.c_str()) != 0) {
    ::unlinkat(folder.get(), part.c_str(), 0);
  }
}

void KeptFiles::trim() const {
  const FileDescriptor folder = open_folder(folder_);
  if (!folder) return;
  std::vector<Entry> entries = entries_of(folder.get(), ending_);
  std::ranges::sort(entries, is_older);
  std::uint64_t bytes = 0;
  for (const Entry& entry : entries) bytes += entry.bytes;
  for (const Entry& entry : entries) {
    if (bytes <= bytes_max_) break;
    ::unlinkat(folder.get(), entry.name.c_str(), 0);
    bytes -= entry.bytes;
  }
}

}  // namespace airlight
