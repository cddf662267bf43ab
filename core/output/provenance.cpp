#include "core/output/provenance.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <system_error>

#include "core/error.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

constexpr std::array<char, 4> kMagic = {'\x76', '\x2f', '\x31', '\x01'};

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

std::uint32_t read_number(std::istream& in) {
  std::array<char, 4> bytes{};  // low byte first
  if (!in.read(bytes.data(), bytes.size())) {
    throw std::runtime_error("its header has no end");
  }
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8 | static_cast<std::uint8_t>(bytes[i]);
  }
  return number;
}

// The string attributes of the first header: (name, type, size, value) until an empty name. Read here and not through
// OpenEXR, which takes gigabytes on the word of a damaged size before it meets the end of the file.
std::map<std::string, std::string> read_strings(std::istream& in, std::uint64_t file_size) {
  std::map<std::string, std::string> strings;
  in.seekg(kMagic.size());
  if ((read_number(in) & 0xff) != 2) {  // the version; flags stand above it
    throw std::runtime_error("unknown version of the format");
  }
  for (std::string name = read_name(in); !name.empty(); name = read_name(in)) {
    const std::string type = read_name(in);
    const std::uint32_t size = read_number(in);
    if (size > file_size - static_cast<std::uint64_t>(in.tellg())) {
      throw std::runtime_error("its header is longer than the file");
    }
    std::string value(type == "string" ? size : 0, '\0');
    in.read(value.data(), static_cast<std::streamsize>(value.size()));
    in.seekg(static_cast<std::streamoff>(size - value.size()), std::ios::cur);
    strings.emplace(std::move(name), std::move(value));
  }
  return strings;
}

}  // namespace

bool is_exr(const std::filesystem::path& file) {
  std::array<char, 4> magic{};
  std::ifstream in(file, std::ios::binary);
  return in.read(magic.data(), magic.size()) && magic == kMagic;
}

Provenance read_provenance(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw InputError(name + ": no such file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(name + ": is not a file; expected an EXR written by airlight");
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(name + ": cannot be read: " + std::strerror(errno));
  }
  if (!is_exr(file)) {
    throw InputError(name + ": is not an EXR file; expected one written by airlight, or a preset (.json)");
  }
  std::map<std::string, std::string> strings;
  try {
    strings = read_strings(in, std::filesystem::file_size(file));
  } catch (const std::exception& reason) {
    throw InputError(name + ": the EXR is damaged or cut short: " + reason.what());
  }
  if (!strings.contains(kPresetKey)) {
    throw InputError(name + ": was not written by airlight: it has no attribute " + std::string(kPresetKey) +
                     "; give a preset (.json) or an EXR made by airlight render");
  }
  return {strings[kPresetKey], strings[kMethodKey], strings[kVersionKey], strings[kDeviceKey]};
}

}  // namespace airlight
