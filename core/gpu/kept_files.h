#pragma once
// Frozen modules, and baked tables, kept in a folder of the user's from one start to the next, for any number of
// processes at once.
//
// Modules are code, so a file counts only where nobody else can have put it there or changed it: folder and file belong
// to the user, others may not write to them, and the file says what it holds and carries its hash. A fault in folder or
// file counts as if nothing were kept. It is no error, since only time is lost.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/gpu/sha256.h"

namespace airlight {

// Folder for data that saves time at later starts: $AIRLIGHT_CACHE, else $XDG_CACHE_HOME/airlight, else
// $HOME/.cache/airlight. Empty where $AIRLIGHT_CACHE is "off" or empty, and where the others hold no absolute path.
std::filesystem::path user_cache_folder();

class KeptFiles {
 public:
  static constexpr std::uint64_t kBytesMax = std::uint64_t{128} << 20U;
  static constexpr std::size_t kWordsMax = std::size_t{4} << 20U;  // of one file; longer files are not kept

  // `folder` empty: nothing is kept. The folder, with up to two above it, is made when the first file is kept.
  // `ending`: of the files' names, ".module".
  KeptFiles(std::filesystem::path folder, std::string ending, std::uint64_t bytes_max = kBytesMax)
      : folder_(std::move(folder)), ending_(std::move(ending)), bytes_max_(bytes_max) {}

  // The words of this key; empty where they are not kept.
  std::vector<std::uint32_t> find(const Digest& key) const;
  // Writes the file whole or not at all, and replaces an existing one.
  void keep(const Digest& key, std::span<const std::uint32_t> words) const;
  // Removes the least recently used files until the rest is within the bound, and half-written files of killed
  // processes.
  void trim() const;

 private:
  std::filesystem::path folder_;
  std::string ending_;
  std::uint64_t bytes_max_;
};

}  // namespace airlight
