#include "core/output/exr_header.h"

#include <stdexcept>

#include "core/output/long_text.h"

namespace airlight {
namespace {

constexpr int kMagicBytes = 4;
constexpr std::uint32_t kLongestPlainValue = 64;

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

// (name, type, size, value) until an empty name.
ExrHeader read_exr_header(std::istream& in, std::uint64_t file_size) {
  ExrHeader header;
  in.seekg(kMagicBytes);
  const auto version = static_cast<std::uint32_t>(read_little_endian(in, 4));
  if ((version & 0xff) != 2) {
    throw std::runtime_error("unknown version of the format");
  }
  header.flags = version & ~0xffU;
  for (std::string name = read_name(in); !name.empty(); name = read_name(in)) {
    ExrAttribute attribute{read_name(in), {}};
    const auto size = static_cast<std::uint32_t>(read_little_endian(in, 4));
    if (size > file_size - static_cast<std::uint64_t>(in.tellg())) {
      throw std::runtime_error("its header is longer than the file");
    }
    const bool kept = attribute.type == "string" || size <= kLongestPlainValue;
    attribute.value.resize(kept ? size : 0);
    in.read(attribute.value.data(), static_cast<std::streamsize>(attribute.value.size()));
    in.seekg(static_cast<std::streamoff>(size - attribute.value.size()), std::ios::cur);
    header.attributes.emplace(std::move(name), std::move(attribute));
  }
  header.end = static_cast<std::uint64_t>(in.tellg());
  return header;
}

}  // namespace airlight
