#include "core/gpu/stored_tables.h"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/gpu/image.h"
#include "core/gpu/kept_values.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytesMax = std::size_t{64} << 20U;  // of larger ones most would not fit into a file

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

// Shapes of buffers, as describe_shape() has them of images.
std::string buffer_shape(const BufferDesc& buffer) {
  return std::to_string(buffer.bytes) + " bytes by " + std::to_string(buffer.slice);
}

}  // namespace

std::string program_build() {
  std::string id;
  ::dl_iterate_phdr(find_build_id, &id);
  return id;
}

StoredTables::StoredTables(fs::path folder, fs::path buffers, fs::path built, const DeviceInfo& device, bool teams)
    : maker_(maker_of(folder, device, teams)),
      stores_buffers_(!maker_.empty() && !buffers.empty()),
      files_(std::move(folder), ".table"),
      buffers_(std::move(buffers), ".buffer"),
      built_buffers_(built.empty() ? fs::path() : built.parent_path() / "buffers", ".buffer"),
      built_(std::move(built), ".table") {}

bool StoredTables::takes(const ImageDesc& table) const {
  return table.stored && !table.key.empty() && !maker_.empty();
}

bool StoredTables::takes(const BufferDesc& buffer) const {
  return stores_buffers_ && !buffer.stored.empty() && buffer.slice > 0 && buffer.bytes <= kBufferBytesMax;
}

Digest StoredTables::key_of(const std::string& shape, const std::string& key) const {
  const std::string text = maker_ + '\n' + shape + '\n' + key;
  return sha256(std::as_bytes(std::span(text)));
}

std::vector<std::uint32_t> StoredTables::find(const ImageDesc& table) const {
  if (!takes(table)) return {};
  const Digest key = key_of(describe_shape(table), table.key);
  std::vector<std::uint32_t> words = files_.find(key);
  if (words.empty()) words = built_.find(key);
  return words.size() * sizeof(words[0]) == table.bytes() ? words : std::vector<std::uint32_t>();
}

std::vector<std::uint32_t> StoredTables::find(const BufferDesc& buffer) const {
  if (!takes(buffer)) return {};
  const Digest key = key_of(buffer_shape(buffer), buffer.stored);
  std::vector<std::uint32_t> words = unpacked(buffers_.find(key));
  if (words.empty()) words = unpacked(built_buffers_.find(key));
  if (words.size() * sizeof(words[0]) != buffer.bytes) return {};
  for (std::size_t i = words.size() - std::min<std::size_t>(buffer.slice, words.size()); i-- > 0;) {
    words[i] ^= words[i + buffer.slice];
  }
  return words;
}

void StoredTables::keep(const ImageDesc& table, std::span<const std::uint32_t> words) const {
  if (takes(table)) files_.keep(key_of(describe_shape(table), table.key), words);
}

// Where a value stands once more a slice farther on, zero takes its place: packing leaves little of zeros.
void StoredTables::keep(const BufferDesc& buffer, std::vector<std::uint32_t> words) const {
  if (!takes(buffer)) return;
  for (std::size_t i = 0; i + buffer.slice < words.size(); ++i) {
    words[i] ^= words[i + buffer.slice];
  }
  buffers_.keep(key_of(buffer_shape(buffer), buffer.stored), packed(words));
}

void StoredTables::trim() const {
  files_.trim();
  buffers_.trim();
}

}  // namespace airlight
