#include "core/output/exr_header.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/output/first_bytes.h"
#include "core/output/long_text.h"

namespace airlight {
namespace {

constexpr std::uint32_t kLongestPlainValue = 64;

// Flags of the file above its version.
constexpr std::uint32_t kTiled = 0x200;
constexpr std::uint32_t kDeep = 0x800;
constexpr std::uint32_t kSeveralParts = 0x1000;

// Rows of a chunk by OpenEXR's code of the compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr std::array<std::int64_t, 10> kRowsOfChunk = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// The most bytes that one byte can stand for, by the same codes: runs of 128 in two bytes, 1032 by deflate, and PXR24
// leaves a quarter of a float out. The other codes have no such limit.
constexpr std::array<double, 6> kMostBytesFromOne = {1.0, 64.0, 1032.0, 1032.0, kNoLimit, 1376.0};

constexpr std::int64_t kHalf = 1;  // OpenEXR's code of the type

// Text up to and without its final zero; names in an EXR have at most 255 bytes.
std::string read_name(std::istream& in) {
  std::string name;
  for (char c = 0; in.get(c) && c != '\0';) {
    name += c;
    if (name.size() > 255) {
      throw std::runtime_error("a name in its header has no end");
    }
  }
  if (!in) {
    throw std::runtime_error("its header has no end");
  }
  return name;
}

// The value of an attribute that has `bytes` bytes; null for any other.
const std::string* plain_value(const ExrHeader& header, const char* name, std::size_t bytes) {
  const auto found = header.attributes.find(name);
  return found != header.attributes.end() && found->second.value.size() == bytes ? &found->second.value : nullptr;
}

std::int64_t little_endian_int(const std::string& bytes, std::size_t at) {
  std::int32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);  // EXR's order is that of every machine with Vulkan
  return value;
}

// Bytes of the types of one length, which OpenEXR reads whatever size the file says: from there on it would take the
// header for another than we do.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 24> kBytesOfType = {{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"lineOrder", 1},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

void require_size_of_type(const std::string& name, const std::string& type, std::uint32_t size) {
  const auto* const known = std::ranges::find(kBytesOfType, type, &std::pair<std::string_view, std::uint32_t>::first);
  if (known != kBytesOfType.end() && known->second != size) {
    throw std::runtime_error("its attribute " + one_line(name) + " has " + std::to_string(size) + " bytes, where a " +
                             type + " has " + std::to_string(known->second));
  }
}

// Into how many pieces of a length, the last perhaps shorter, something falls.
std::int64_t pieces(std::int64_t whole, std::int64_t length) {
  return (whole + length - 1) / length;
}

// Lengths within a value of `size` bytes, for which OpenEXR takes memory before it reads them: texts of a list, and a
// preview's pixels. Leaves the stream where it was.
void require_room_inside(std::istream& in, const std::string& type, std::uint32_t size) {
  const auto start = in.tellg();
  if (type == "preview" && size >= 8) {
    const std::uint64_t columns = read_little_endian(in, 4);
    const std::uint64_t rows = read_little_endian(in, 4);
    if (columns * rows > (size - 8) / 4) {
      throw std::runtime_error("its preview is longer than its header");
    }
  }
  if (type == "stringvector") {
    for (std::uint64_t at = 0; at + 4 <= size;) {
      const std::uint64_t length = read_little_endian(in, 4);
      at += 4 + length;
      if (at > size) {
        throw std::runtime_error("a text in its header is longer than the header");
      }
      in.seekg(static_cast<std::streamoff>(length), std::ios::cur);
    }
  }
  in.seekg(start);
}

// (name, type, size, value) until an empty name.
ExrHeader read_part(std::istream& in, std::uint32_t flags, std::uint64_t file_size) {
  ExrHeader header;
  header.flags = flags;
  for (std::string name = read_name(in); !name.empty(); name = read_name(in)) {
    ExrAttribute attribute{read_name(in), {}};
    const auto size = static_cast<std::uint32_t>(read_little_endian(in, 4));
    if (size > file_size - static_cast<std::uint64_t>(in.tellg())) {
      throw std::runtime_error("its header is longer than the file");
    }
    require_size_of_type(name, attribute.type, size);
    require_room_inside(in, attribute.type, size);
    const bool kept = attribute.type == "string" || attribute.type == "chlist" || size <= kLongestPlainValue;
    attribute.value.resize(kept ? size : 0);
    in.read(attribute.value.data(), static_cast<std::streamsize>(attribute.value.size()));
    in.seekg(static_cast<std::streamoff>(size - attribute.value.size()), std::ios::cur);
    header.attributes.emplace(std::move(name), std::move(attribute));
  }
  header.end = static_cast<std::uint64_t>(in.tellg());
  return header;
}

}  // namespace

std::uint64_t read_little_endian(std::istream& in, int bytes) {
  std::uint64_t number = 0;
  for (int i = 0; i < bytes; ++i) {
    const int byte = in.get();
    if (byte < 0) {
      throw std::runtime_error("its header has no end");
    }
    number |= static_cast<std::uint64_t>(byte) << (8 * i);
  }
  return number;
}

std::optional<std::string> text_of(const ExrHeader& header, const std::string& name) {
  return text_in(name, [&](const std::string& key) {
    const auto found = header.attributes.find(key);
    const bool is_text = found != header.attributes.end() && found->second.type == "string";
    return is_text ? std::optional(found->second.value) : std::nullopt;
  });
}

namespace {

// Fewest bytes that the pixels of the first level take; 0 when the header does not tell.
std::uint64_t fewest_pixel_bytes(const ExrHeader& header) {
  const std::string* const window = plain_value(header, "dataWindow", 16);
  const std::string* const compression = plain_value(header, "compression", 1);
  const auto channels = header.attributes.find("channels");
  const auto code = static_cast<std::size_t>(compression == nullptr ? 255 : compression->front());
  if (window == nullptr || channels == header.attributes.end() || code >= kMostBytesFromOne.size()) {
    return 0;
  }
  // Name, zero, then 16 bytes: type of value, linear or not, samples across and down.
  double bytes_a_pixel = 0.0;
  const std::string& list = channels->second.value;
  for (std::size_t at = list.find('\0'); at != std::string::npos && at + 17 <= list.size();
       at = list.find('\0', at + 18)) {
    const double across = std::max<double>(1.0, static_cast<double>(little_endian_int(list, at + 9)));
    const double down = std::max<double>(1.0, static_cast<double>(little_endian_int(list, at + 13)));
    bytes_a_pixel += (little_endian_int(list, at + 1) == kHalf ? 2.0 : 4.0) / (across * down);
  }
  const auto pixels = static_cast<double>(little_endian_int(*window, 8) - little_endian_int(*window, 0) + 1) *
                      static_cast<double>(little_endian_int(*window, 12) - little_endian_int(*window, 4) + 1);
  return static_cast<std::uint64_t>(std::max(0.0, pixels) * bytes_a_pixel / kMostBytesFromOne[code]);
}

}  // namespace

std::int64_t chunk_count(const ExrHeader& header) {
  const std::string* const window = plain_value(header, "dataWindow", 16);
  const std::string* const compression = plain_value(header, "compression", 1);
  if (window == nullptr || compression == nullptr) {
    return 0;
  }
  const std::int64_t columns = little_endian_int(*window, 8) - little_endian_int(*window, 0) + 1;
  const std::int64_t rows = little_endian_int(*window, 12) - little_endian_int(*window, 4) + 1;
  if (columns < 1 || rows < 1) {
    return 0;
  }
  if (is_tiled(header)) {
    const std::string* const tiles = plain_value(header, "tiles", 9);
    const std::int64_t across = tiles == nullptr ? 0 : little_endian_int(*tiles, 0);
    const std::int64_t down = tiles == nullptr ? 0 : little_endian_int(*tiles, 4);
    return across < 1 || down < 1 ? 0 : pieces(columns, across) * pieces(rows, down);
  }
  const auto code = static_cast<std::size_t>(static_cast<unsigned char>(compression->front()));
  return code < kRowsOfChunk.size() ? pieces(rows, kRowsOfChunk[code]) : 0;
}

bool is_tiled(const ExrHeader& header) {
  return (header.flags & kTiled) != 0 || plain_value(header, "tiles", 9) != nullptr;
}

ExrHeader read_exr_header(std::istream& in, std::uint64_t file_size) {
  in.seekg(kExrMagic.size());
  const auto version = static_cast<std::uint32_t>(read_little_endian(in, 4));
  if ((version & 0xff) != 2) {
    throw std::runtime_error("unknown version of the format");
  }
  return read_part(in, version & ~0xffU, file_size);
}

namespace {

// Without one of these OpenEXR takes its own default, and nothing tells how much the pixels may be.
void require_what_sizes_pixels(const ExrHeader& header) {
  for (const auto& [name, type] :
       {std::pair{"channels", "chlist"}, {"compression", "compression"}, {"dataWindow", "box2i"}}) {
    const auto found = header.attributes.find(name);
    if (found == header.attributes.end() || found->second.type != type) {
      throw std::runtime_error(std::string("its header has no attribute ") + name);
    }
  }
}

}  // namespace

void require_room_for_exr(const std::filesystem::path& file) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in || !starts_with(in, kExrMagic)) {
    return;
  }
  ExrHeader header = read_exr_header(in, size);
  const bool several = (header.flags & kSeveralParts) != 0;
  std::uint64_t wanted = 0;  // bytes after the headers
  do {
    require_what_sizes_pixels(header);
    const bool holds_pixels = (header.flags & kDeep) == 0;  // deep pixels may have no samples
    wanted += 8 * static_cast<std::uint64_t>(chunk_count(header)) + (holds_pixels ? fewest_pixel_bytes(header) : 0);
    if (wanted > size - header.end) {
      throw std::runtime_error("it has fewer bytes than its header asks for");
    }
    header = several ? read_part(in, header.flags, size) : ExrHeader{};
  } while (!header.attributes.empty());
}

}  // namespace airlight
