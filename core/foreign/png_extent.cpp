#include "core/foreign/png_extent.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

#include "core/output/first_bytes.h"

namespace airlight::foreign {
namespace {

// Big-endian; 0 at the end of the file.
std::uint32_t number(std::istream& in) {
  std::array<unsigned char, 4> bytes{};
  in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U | std::uint32_t{bytes[2]} << 8U | bytes[3];
}

// The checksum of the chunk's name and of its contents, which it reads.
uLong checksum(std::istream& in, const std::string& name, std::uint32_t length) {
  std::array<char, 1U << 14U> piece{};
  uLong sum = crc32(0, reinterpret_cast<const Bytef*>(name.data()), static_cast<uInt>(name.size()));
  while (length > 0 && in) {
    const auto count = std::min<std::uint32_t>(length, piece.size());
    in.read(piece.data(), count);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(piece.data()), count);
    length -= count;
  }
  return sum;
}

}  // namespace

// A chunk is a length, a name, contents and a checksum (ISO/IEC 15948, clause 5.3); a capital begins a name that the
// picture needs.
void require_whole_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!starts_with(in, kPngMagic)) {
    return;
  }
  constexpr std::streamoff kSignature = 8;
  in.seekg(kSignature);
  for (std::string name(4, '\0'); name != "IEND";) {
    const std::uint32_t length = number(in);
    in.read(name.data(), 4);
    const uLong sum = checksum(in, name, length);
    const std::uint32_t given = number(in);
    if (!in) {
      throw std::runtime_error("it has no end");
    }
    if (sum != given && name[0] >= 'A' && name[0] <= 'Z') {
      throw std::runtime_error("the checksum of its chunk " + name + " does not fit");
    }
  }
}

}  // namespace airlight::foreign
