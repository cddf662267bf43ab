#include "core/output/provenance.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "core/error.h"
#include "core/output/exr_header.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

constexpr std::array<char, 4> kMagic = {'\x76', '\x2f', '\x31', '\x01'};

}  // namespace

bool is_exr(std::istream& in) {
  std::array<char, 4> magic{};
  const bool same = in.read(magic.data(), magic.size()) && magic == kMagic;
  in.clear();
  in.seekg(0);
  return same;
}

bool is_exr(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return in && is_exr(in);
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
  return read_provenance(in, name);
}

Provenance read_provenance(std::istream& in, const std::string& name) {
  if (!is_exr(in)) {
    throw InputError(name + ": is not an EXR file; expected one written by airlight, or a preset (.json)");
  }
  in.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(in.tellg());
  ExrHeader header;
  try {
    header = read_exr_header(in, size);
  } catch (const std::exception& reason) {
    throw InputError(name + ": the EXR is damaged or cut short: " + reason.what());
  }
  const std::optional<std::string> preset = text_of(header, kPresetKey);
  if (!preset) {
    throw InputError(name + ": was not written by airlight: it has no attribute " + std::string(kPresetKey) +
                     "; give a preset (.json) or an EXR made by airlight render");
  }
  const auto text = [&](const char* key) { return text_of(header, key).value_or(""); };
  return {*preset, text(kMethodKey), text(kVersionKey), text(kDeviceKey)};
}

}  // namespace airlight
