#include "core/foreign/tiff_extent.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <vector>

namespace airlight::foreign {
namespace {

// Tags of a directory's entries (TIFF 6.0, sections 8 and 15).
constexpr std::uint64_t kStripOffsets = 273;
constexpr std::uint64_t kStripBytes = 279;
constexpr std::uint64_t kTileOffsets = 324;
constexpr std::uint64_t kTileBytes = 325;

// The file's numbers: low byte first or last, of 32 bits or, in a BigTIFF, of 64.
class TiffReader {
 public:
  explicit TiffReader(const std::filesystem::path& file) : in_(file, std::ios::binary) {
    std::error_code problem;
    size_ = std::filesystem::file_size(file, problem);
    std::array<char, 4> magic{};
    in_.read(magic.data(), magic.size());
    little_ = magic[0] == 'I';
    const bool order = magic[0] == magic[1] && (little_ || magic[0] == 'M');
    const int version = little_ ? magic[2] : magic[3];
    const bool rest = (little_ ? magic[3] : magic[2]) == 0;
    good_ = !problem && in_ && order && rest && (version == 42 || version == 43);
    big_ = version == 43;
  }

  bool is_tiff() const { return good_; }

  void check() {
    constexpr int kMostPictures = 64;
    std::uint64_t at = big_ ? number(8, 8) : number(4, 4);
    for (int k = 0; at != 0 && k < kMostPictures; ++k) {
      at = check_directory(at);
    }
  }

 private:
  struct Entry {
    std::uint64_t place = 0;  // of its values
    std::uint64_t count = 0;
    int bytes = 0;  // of a value
  };

  [[noreturn]] static void fail() { throw std::runtime_error("it is shorter than its directory says"); }

  std::uint64_t number(std::uint64_t at, int bytes) {
    std::array<unsigned char, 8> read{};
    if (at > size_ || size_ - at < static_cast<std::uint64_t>(bytes)) {
      fail();
    }
    in_.seekg(static_cast<std::streamoff>(at));
    in_.read(reinterpret_cast<char*>(read.data()), bytes);
    std::uint64_t value = 0;
    for (int k = 0; k < bytes; ++k) {
      value = value << 8U | read[static_cast<std::size_t>(little_ ? bytes - 1 - k : k)];
    }
    return value;
  }

  // Returns the place of the next directory, 0 after the last.
  std::uint64_t check_directory(std::uint64_t at) {
    const std::uint64_t wide = big_ ? 8 : 4;
    const std::uint64_t entry_bytes = 4 + 2 * wide;
    const std::uint64_t count = number(at, big_ ? 8 : 2);
    at += big_ ? 8 : 2;
    if (count > size_ / entry_bytes) {
      fail();
    }
    std::optional<Entry> offsets;
    std::optional<Entry> lengths;
    for (std::uint64_t k = 0; k < count; ++k, at += entry_bytes) {
      const std::uint64_t tag = number(at, 2);
      if (tag != kStripOffsets && tag != kStripBytes && tag != kTileOffsets && tag != kTileBytes) {
        continue;
      }
      const std::uint64_t type = number(at + 2, 2);
      Entry entry{at + 4 + wide, number(at + 4, static_cast<int>(wide)), type == 3 ? 2 : type == 16 ? 8 : 4};
      if (entry.count > size_) {
        fail();
      }
      if (entry.count * static_cast<std::uint64_t>(entry.bytes) > wide) {
        entry.place = number(entry.place, static_cast<int>(wide));
      }
      (tag == kStripOffsets || tag == kTileOffsets ? offsets : lengths) = entry;
    }
    for (std::uint64_t k = 0; offsets && lengths && k < std::min(offsets->count, lengths->count); ++k) {
      const std::uint64_t first = value_of(*offsets, k);
      if (first > size_ || value_of(*lengths, k) > size_ - first) {
        fail();
      }
    }
    return number(at, static_cast<int>(wide));
  }

  std::uint64_t value_of(const Entry& entry, std::uint64_t k) {
    return number(entry.place + k * static_cast<std::uint64_t>(entry.bytes), entry.bytes);
  }

  std::ifstream in_;
  std::uint64_t size_ = 0;
  bool little_ = true;
  bool big_ = false;
  bool good_ = false;
};

}  // namespace

void require_whole_tiff(const std::filesystem::path& file) {
  if (TiffReader tiff(file); tiff.is_tiff()) {
    tiff.check();
  }
}

}  // namespace airlight::foreign
