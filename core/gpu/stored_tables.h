#pragma once
// Tables that depend on the air alone (ImageDesc::stored), and buffers that a processor reads sooner than it makes them
// (BufferDesc::stored), kept in the user's cache folder. A later start with the same air reads them back bit for bit.

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
  // `folder` empty: nothing is stored. `buffers`: likewise for buffers, so that those of many suns push out no table of
  // the air. `built`: of tables that the build left, beside its "buffers", which are only read; may be empty. `teams`:
  // whether passes get teams, whose sums round differently.
  StoredTables(std::filesystem::path folder, std::filesystem::path buffers, std::filesystem::path built,
               const DeviceInfo& device, bool teams);

  // Whether the table is to be stored and a folder exists.
  bool takes(const ImageDesc& table) const;
  bool takes(const BufferDesc& buffer) const;
  // Empty where the table is not stored.
  std::vector<std::uint32_t> find(const ImageDesc& table) const;
  std::vector<std::uint32_t> find(const BufferDesc& buffer) const;
  void keep(const ImageDesc& table, std::span<const std::uint32_t> words) const;
  void keep(const BufferDesc& buffer, std::vector<std::uint32_t> words) const;
  // To be called after tables were kept.
  void trim() const;

 private:
  Digest key_of(const std::string& shape, const std::string& key) const;

  std::string maker_;  // program, device and driver, which decide the rounding; empty: nothing is stored
  bool stores_buffers_;
  KeptFiles files_;
  KeptFiles buffers_;
  KeptFiles built_buffers_;
  KeptFiles built_;
};

// An id from the linker's note that no other build of the program has; empty where the linker wrote none.
std::string program_build();

}  // namespace airlight
