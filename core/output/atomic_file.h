#pragma once
// Files that appear whole or not at all: written under a temporary name in the same folder, synced, then renamed.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace airlight {

// Checks before long work that a file can be written. Throws InputError: empty name, target a directory, folder missing
// or not writable, existing file not writable.
void require_writable(const std::filesystem::path& file);

// Writes pipes, devices and names of open descriptors (/dev/stdout) in place. Throws RunError with the path and the
// system's reason; then no temporary file stays behind, and an older file of that name is unchanged.
void write_file(const std::filesystem::path& file, std::span<const std::byte> contents);

inline void write_file(const std::filesystem::path& file, const std::string& text) {
  write_file(file, std::as_bytes(std::span(text)));
}

// Writes a file piece by piece: `next` returns one piece after the other, an empty one at the end.
void write_file(const std::filesystem::path& file, const std::function<std::span<const std::byte>()>& next);

// A file that may exceed memory; nobody reads it before commit(). Without commit(), or when a signal ends the process,
// nothing stays behind and an older file of that name is unchanged. Pipes, devices and open descriptors are written in
// place.
class FileInProgress {
 public:
  // Of pieces. onward: each one follows the last. held: any, and what a rename cannot replace is opened at commit(),
  // its contents kept in memory until then.
  enum class Order { any, onward, held };

  // Throws RunError with the path and the system's reason. Throws InputError for a pipe, device or open descriptor,
  // where no write can go back, if the order is any.
  explicit FileInProgress(const std::filesystem::path& file, Order order = Order::any);
  FileInProgress(const FileInProgress&) = delete;
  FileInProgress& operator=(const FileInProgress&) = delete;
  ~FileInProgress();

  // Writes at a byte position. After it has thrown RunError, commit() throws it again.
  void write(std::uint64_t position, std::span<const std::byte> contents);
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Removes temporary files that killed writers have left in a folder, for targets whose name `is_target` accepts.
// Writers lock their temporary file, so that those still at work, here or on another machine, keep theirs. Never
// throws: a file that cannot be removed stays.
void remove_abandoned_files(const std::filesystem::path& folder,
                            const std::function<bool(const std::string& name)>& is_target) noexcept;

// The same for the temporary files of this one target.
void remove_abandoned_files_of(const std::filesystem::path& file) noexcept;

}  // namespace airlight
