#include "core/foreign/vdb_head.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace airlight::foreign {
namespace {

// openvdb/io/Archive.cc, readHeader(), and GridDescriptor.cc, read(); numbers have the low byte first.
constexpr std::uint64_t kVdbMagic = 0x56444220;
constexpr std::uint64_t kOldestVersion = 222;  // from here on each grid says how it is compressed
constexpr std::size_t kUniqueIdBytes = 36;
constexpr std::uint64_t kLongestText = 1U << 20U;
constexpr std::uint64_t kMostEntries = 4096;
constexpr char kNameEnd = '\x1e';  // before the number of a grid whose name is not the only one of its kind

class VdbReader {
 public:
  explicit VdbReader(const std::filesystem::path& file) : in_(file, std::ios::binary) {
    std::error_code problem;
    size_ = std::filesystem::file_size(file, problem);
    if (problem || !in_) {
      throw std::runtime_error("cannot be read");
    }
  }

  std::vector<VdbGrid> read() {
    if (size_ < 8 || number(8) != kVdbMagic) {
      throw std::runtime_error(
          "is no OpenVDB file; expected one, or for a grid as plain text a name that does not end in .vdb");
    }
    const std::uint64_t version = number(4);
    if (version < kOldestVersion) {
      throw std::runtime_error("is of OpenVDB's file version " + std::to_string(version) +
                               ", and 222 is the oldest that airlight reads; write it again with OpenVDB 2.2 or newer");
    }
    skip(8);  // the library's version
    if (number(1) != 1) {
      throw std::runtime_error("was streamed, without its grids' places; write it again as a file");
    }
    skip(kUniqueIdBytes);
    metadata();
    return grids();
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("damaged or cut short: its grids go on beyond its end"); }

  void need(std::uint64_t bytes) const {
    if (bytes > size_ - at_) {
      fail();
    }
  }
  void go_to(std::uint64_t place) {
    if (place < at_ || place > size_) {
      fail();
    }
    at_ = place;
    in_.seekg(static_cast<std::streamoff>(at_));
  }
  void skip(std::uint64_t bytes) {
    need(bytes);
    go_to(at_ + bytes);
  }

  std::uint64_t number(int bytes) {
    std::array<unsigned char, 8> read{};
    need(static_cast<std::uint64_t>(bytes));
    in_.read(reinterpret_cast<char*>(read.data()), bytes);
    at_ += static_cast<std::uint64_t>(bytes);
    std::uint64_t value = 0;
    for (int k = bytes - 1; k >= 0; --k) {
      value = value << 8U | read[static_cast<std::size_t>(k)];
    }
    return value;
  }

  std::string text() {
    const std::uint64_t length = number(4);
    need(length);
    if (length > kLongestText) {
      fail();
    }
    std::string value(length, '\0');
    in_.read(value.data(), static_cast<std::streamsize>(length));
    at_ += length;
    return value;
  }

  std::uint64_t count() {
    const std::uint64_t entries = number(4);
    if (entries > kMostEntries) {
      fail();
    }
    return entries;
  }

  void metadata() {
    for (std::uint64_t k = count(); k > 0; --k) {
      text();  // name
      text();  // type
      skip(number(4));
    }
  }

  std::vector<VdbGrid> grids() {
    std::vector<VdbGrid> list;
    for (std::uint64_t k = count(); k > 0; --k) {
      const std::string name = text();
      const std::string type = text();
      text();    // the grid whose tree it shares
      skip(16);  // where tree and blocks begin
      const std::uint64_t end = number(8);
      go_to(end);
      list.push_back(
          {name.substr(0, name.find(kNameEnd)), type.starts_with("Tree_float_") || type.starts_with("Tree_double_")});
    }
    return list;
  }

  std::ifstream in_;
  std::uint64_t size_ = 0;
  std::uint64_t at_ = 0;
};

}  // namespace

std::vector<VdbGrid> vdb_grids(const std::filesystem::path& file) {
  return VdbReader(file).read();
}

}  // namespace airlight::foreign
