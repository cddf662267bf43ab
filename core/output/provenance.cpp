#include "core/output/provenance.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <system_error>

#include "core/base/error.h"
#include "core/output/exr_header.h"
#include "core/output/first_bytes.h"
#include "core/output/png_texts.h"
#include "core/output/provenance_keys.h"

namespace airlight {
namespace {

using Find = std::function<std::optional<std::string>(const std::string& name)>;

// The texts of the file's header, by name.
Find texts_of_exr(std::istream& in, std::uint64_t size, const std::string& file) {
  try {
    return [header = read_exr_header(in, size)](const std::string& name) { return text_of(header, name); };
  } catch (const std::exception& reason) {
    throw InputError(file + ": the EXR is damaged or cut short: " + reason.what());
  }
}

Find texts_of_png(std::istream& in, std::uint64_t size) {
  return [png = read_png_texts(in, size)](const std::string& name) {
    const auto found = png.texts.find(name);
    return found == png.texts.end() ? std::nullopt : std::optional(found->second);
  };
}

}  // namespace

std::string version_note(const std::string& theirs, const std::string& ours) {
  if (theirs.empty() || ours.empty() || theirs == ours) {
    return {};
  }
  return "airlight " + theirs + " made it, and this is airlight " + ours + "; the same preset may look otherwise";
}

bool is_exr(std::istream& in) {
  return starts_with(in, kExrMagic);
}

bool is_png(std::istream& in) {
  return starts_with(in, kPngMagic);
}

bool is_exr(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return in && is_exr(in);
}

bool is_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return in && is_png(in);
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
  const bool png = is_png(in);
  if (!png && !is_exr(in)) {
    throw InputError(name +
                     ": is not an EXR file; expected one written by airlight, a PNG of its own, or a preset (.json)");
  }
  in.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(in.tellg());
  const Find text = png ? texts_of_png(in, size) : texts_of_exr(in, size, name);
  const std::optional<std::string> preset = text(kPresetKey);
  if (!preset) {
    throw InputError(name + ": was not written by airlight: it has no " + (png ? "text " : "attribute ") +
                     std::string(kPresetKey) + "; give a preset (.json), or an EXR or PNG made by airlight render");
  }
  return {*preset, text(kMethodKey).value_or(""), text(kVersionKey).value_or(""), text(kDeviceKey).value_or("")};
}

}  // namespace airlight
