#pragma once
// Frozen modules, and baked tables, kept in a folder of the user's from one start to the next, for any number of
// processes at once.
//
// Modules are code, so a file counts only where nobody else can have put it there or changed it: folder and file belong
// to the user, others may not write to them, and the file says what it holds and carries its hash. Whatever is wrong
// with folder or file, it is as if nothing were kept; no error, since nothing is lost but time.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/gpu/sha256.h"

namespace airlight {

// Where airlight keeps what only saves time: $AIRLIGHT_CACHE, else $XDG_CACHE_HOME/airlight, else
// $HOME/.cache/airlight. Empty where $AIRLIGHT_CACHE is "off" or empty, and where the others name no absolute path.
std::filesystem::path user_cache_folder();

class KeptFiles {
 public:
  static constexpr std::uint64_t kBytesMax = std::uint64_t{64} << 20U;
  static constexpr std::size_t kWordsMax = std::size_t{4} << 20U;  // of one file; longer ones are not kept

  // `folder` empty: keeps nothing. It is made, with up to two folders above it, when something is first kept. `ending`:
  // of the files' names, ".module".
  KeptFiles(std::filesystem::path folder, std::string ending, std::uint64_t bytes_max = kBytesMax)
      : folder_(std::move(folder)), ending_(std::move(ending)), bytes_max_(bytes_max) {}

  // Empty where it is not kept.
  std::vector<std::uint32_t> find(const Digest& key) const;
  // The file is there as a whole or not at all; one that is there already is replaced.
  void keep(const Digest& key, std::span<const std::uint32_t> words) const;
  // The least recently used files go until the rest has no more than the bound, and with them what killed processes
  // left half written.
  void trim() const;

 private:
  std::filesystem::path folder_;
  std::string ending_;
  std::uint64_t bytes_max_;
};

}  // namespace airlight
