#pragma once
// Files told apart from what they were before.

#include <filesystem>
#include <string>
#include <system_error>

namespace airlight {

// Identifies a file as it is on the disk. If it changes, its identity changes and it is read again.
inline std::string identity_of(const std::string& file) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(file, ignored);
  const auto time = std::filesystem::last_write_time(file, ignored).time_since_epoch().count();
  return file + " " + std::to_string(size) + " " + std::to_string(time);
}

}  // namespace airlight
