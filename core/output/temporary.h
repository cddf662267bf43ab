#pragma once
// Names of files that must not outlive this process unless they are renamed.

#include <string>

namespace airlight {

struct TemporaryName;

// Registers the name of a temporary file for the object's life. The destructor unlinks the file unless it was renamed.
class Temporary {
 public:
  // Throws RunError for a path longer than the system's limit. Waits while more names are in use than there is room
  // for.
  explicit Temporary(const std::string& path);
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary();

  const char* path() const;
  // False with errno where the file does not exist or cannot be renamed.
  bool rename_to(const std::string& target);

 private:
  TemporaryName* slot_ = nullptr;
  bool renamed_ = false;
};

// Unlinks the files of all registered names. Async-signal-safe.
void remove_temporary_files() noexcept;

}  // namespace airlight
