#pragma once
// Tables that the air alone makes (ImageDesc::stored), kept in the user's cache folder: a later start with the same air
// reads what this one baked, every bit of it.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/gpu/executor.h"
#include "core/gpu/kept_files.h"
#include "core/plan/plan.h"

namespace airlight {

class StoredTables {
 public:
  // `folder` empty: nothing is stored. `teams`: whether passes get them, as sums of teams round otherwise.
  StoredTables(std::filesystem::path folder, const DeviceInfo& device, bool teams);

  // Whether the table is to be stored, and there is a place for it.
  bool takes(const ImageDesc& table) const;
  // Empty where the table is not there, or is not to be stored.
  std::vector<std::uint32_t> find(const ImageDesc& table) const;
  void keep(const ImageDesc& table, std::span<const std::uint32_t> words) const;
  // To be called after some were kept.
  void trim() const { files_.trim(); }

 private:
  Digest key_of(const ImageDesc& table) const;

  std::string maker_;  // program, device and driver: whose rounding it is; empty: nothing is stored
  KeptFiles files_;
};

// What no other build of the program shares, of its linker's note; empty where the linker wrote none.
std::string program_build();

}  // namespace airlight
