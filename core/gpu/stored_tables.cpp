#include "core/gpu/stored_tables.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <utility>

#include "core/gpu/image.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

// The GNU build id among the notes of a program segment.
std::string build_id_in(const char* notes, std::size_t bytes) {
  constexpr char kOwner[] = "GNU";
  std::size_t at = 0;
  while (at + sizeof(ElfW(Nhdr)) <= bytes) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes + at, sizeof note);
    const std::size_t name = at + sizeof note;
    const std::size_t contents = name + (note.n_namesz + 3U) / 4U * 4U;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == sizeof kOwner &&
        std::memcmp(notes + name, kOwner, sizeof kOwner) == 0) {
      return {notes + contents, note.n_descsz};
    }
    at = contents + (note.n_descsz + 3U) / 4U * 4U;
  }
  return {};
}

// Whether the object holds this very function: the program, or the shared library that airlight is part of.
bool holds_this(const dl_phdr_info* object) {
  const auto here = reinterpret_cast<ElfW(Addr)>(&holds_this);
  for (ElfW(Half) i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    const ElfW(Addr) start = object->dlpi_addr + segment.p_vaddr;
    if (segment.p_type == PT_LOAD && here >= start && here - start < segment.p_memsz) {
      return true;
    }
  }
  return false;
}

int find_build_id(dl_phdr_info* object, std::size_t /*size*/, void* found) {
  if (!holds_this(object)) {
    return 0;
  }
  for (ElfW(Half) i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    auto& id = *static_cast<std::string*>(found);
    if (segment.p_type == PT_NOTE && id.empty()) {
      // NOLINTNEXTLINE(performance-no-int-to-ptr): an address is all that the loader gives
      id = build_id_in(reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr), segment.p_memsz);
    }
  }
  return 1;
}

std::string maker_of(const fs::path& folder, const DeviceInfo& device, bool teams) {
  const std::string program = folder.empty() ? std::string() : program_build();
  return program.empty() ? program
                         : program + '\n' + device.name + '\n' + device.driver + '\n' + (teams ? "teams" : "alone");
}

}  // namespace

std::string program_build() {
  std::string id;
  ::dl_iterate_phdr(find_build_id, &id);
  return id;
}

StoredTables::StoredTables(fs::path folder, fs::path built, const DeviceInfo& device, bool teams)
    : maker_(maker_of(folder, device, teams)),
      files_(std::move(folder), ".table"),
      built_(std::move(built), ".table") {}

bool StoredTables::takes(const ImageDesc& table) const {
  return table.stored && !table.key.empty() && !maker_.empty();
}

Digest StoredTables::key_of(const ImageDesc& table) const {
  const std::string text = maker_ + '\n' + describe_shape(table) + '\n' + table.key;
  return sha256(std::as_bytes(std::span(text)));
}

std::vector<std::uint32_t> StoredTables::find(const ImageDesc& table) const {
  if (!takes(table)) return {};
  const Digest key = key_of(table);
  std::vector<std::uint32_t> words = files_.find(key);
  if (words.empty()) words = built_.find(key);
  return words.size() * sizeof(words[0]) == table.bytes() ? words : std::vector<std::uint32_t>();
}

void StoredTables::keep(const ImageDesc& table, std::span<const std::uint32_t> words) const {
  if (takes(table)) files_.keep(key_of(table), words);
}

}  // namespace airlight
