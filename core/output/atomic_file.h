#pragma once
// Files that appear whole or not at all: written under a temporary name in the same folder, synced, then renamed.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace airlight {

// To be called before long work. Throws InputError: empty name, target a directory, folder missing or not writable,
// existing file not writable.
void require_writable(const std::filesystem::path& file);

// Pipes, devices and names of open descriptors (/dev/stdout) are written in place. Throws RunError with the path and
// the system's reason; no temporary file is left behind and an older file of that name stays as it was.
void write_file(const std::filesystem::path& file, std::span<const std::byte> contents);

inline void write_file(const std::filesystem::path& file, const std::string& text) {
  write_file(file, std::as_bytes(std::span(text)));
}

// The same for a file made piece by piece: `next` gives one piece after the other, an empty one at the end.
void write_file(const std::filesystem::path& file, const std::function<std::span<const std::byte>()>& next);

// A file of more than memory holds, read by nobody before commit(). Without commit(), and when the process is ended by
// a signal, nothing stays behind and an older file of that name stays as it was. Pipes, devices and open descriptors
// are written in place.
class FileInProgress {
 public:
  enum class Order { any, onward };  // of what is written; onward: each piece follows the last

  // Throws RunError with the path and the system's reason; InputError for a pipe, device or open descriptor, in which
  // one cannot go back, unless all goes onward.
  explicit FileInProgress(const std::filesystem::path& file, Order order = Order::any);
  FileInProgress(const FileInProgress&) = delete;
  FileInProgress& operator=(const FileInProgress&) = delete;
  ~FileInProgress();

  // At a byte position. Throws RunError, and then again in commit().
  void write(std::uint64_t position, std::span<const std::byte> contents);
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Files that another program, started by this process, writes under temporary names. They are removed when this object
// goes, unless they were renamed, and when a signal ends this process, which kills that program first. One at a time.
class FilesOfAnother {
 public:
  explicit FilesOfAnother(const std::vector<std::filesystem::path>& files);
  FilesOfAnother(const FilesOfAnother&) = delete;
  FilesOfAnother& operator=(const FilesOfAnother&) = delete;
  ~FilesOfAnother();

  // Calls `start`, which returns the program's number or 0 for none; a signal waits until that is known.
  pid_t started_by(const std::function<pid_t()>& start);
  // It has ended, but is not yet waited for.
  void ended() noexcept;
  // False: there is no such file, or it cannot be renamed.
  bool rename(std::size_t index, const std::filesystem::path& target);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Removes what killed writers have left in a folder beside files whose name `is_target` accepts. Writers hold a lock on
// their temporary file, so that those at work, here or on another machine, keep theirs. Never throws: what cannot be
// removed stays.
void remove_abandoned_files(const std::filesystem::path& folder,
                            const std::function<bool(const std::string& name)>& is_target) noexcept;

// The same of what was to become this one file.
void remove_abandoned_files_of(const std::filesystem::path& file) noexcept;

// Unlinks the temporary files of every write_file() now running. Async-signal-safe.
void remove_temporary_files() noexcept;

// From now on SIGINT, SIGTERM and SIGHUP unlink the temporary files and say what is whole (core/output/last_words.h),
// then end the process as they would have done; and a file beyond the limit on its size fails to be written, as on a
// full disk, instead of ending the process by SIGXFSZ.
void end_in_good_order_on_signals();

}  // namespace airlight
