#include "app/cli/preset_source.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/cli/carried_preset.h"
#include "core/base/error.h"
#include "core/library/built_in.h"
#include "core/library/embedded_presets.h"
#include "core/output/provenance.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".json";

// No preset and no picture's header is near this size. The limit keeps an endless pipe from filling the memory.
constexpr std::size_t kLongestStream = std::size_t{16} << 20U;

// The preset in a stream that can be read only once: a preset, or a picture of which the header is enough.
Preset from_stream(std::istream& in, const std::string& name, bool any_file) {
  std::string text(kLongestStream, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) {
    throw InputError(name + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
  }
  text.resize(static_cast<std::size_t>(in.gcount()));
  std::istringstream again(text);
  if (is_exr(again) || is_png(again)) {
    return carried_preset(read_provenance(again, name), name, fs::current_path(), any_file);
  }
  if (in) {
    throw InputError(name + ": is larger than 16 MiB; expected a preset (JSON) or an EXR or PNG of airlight's");
  }
  return parse_preset(text, name, fs::current_path(), embedded_presets());
}

bool is_bare_name(const std::string& argument) {
  return argument.find('/') == std::string::npos && !argument.ends_with(kEnding);
}

}  // namespace

Preset find_preset(const std::string& argument, bool any_file) {
  if (argument == "-") {
    return from_stream(std::cin, "standard input", any_file);
  }
  std::error_code error;
  const fs::file_status status = fs::status(argument, error);
  const bool is_file = fs::exists(status) && !fs::is_directory(status);
  if (!is_file && is_bare_name(argument) && (!fs::is_directory(status) || is_built_in(argument))) {
    return built_in_preset(argument, "'airlight presets'");
  }
  if (is_file && !fs::is_regular_file(status)) {
    errno = 0;
    std::ifstream in(argument, std::ios::binary);
    if (!in) {
      throw InputError(argument + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
    }
    return from_stream(in, argument, any_file);
  }
  if (is_exr(argument) || is_png(argument)) {
    return carried_preset(read_provenance(argument), argument, fs::path(argument).parent_path(), any_file);
  }
  if (is_file && (argument.ends_with(".exr") || argument.ends_with(".png"))) {
    throw InputError(argument + ": is no picture: its first bytes are neither an EXR's nor a PNG's");
  }
  return load_preset(argument, embedded_presets());
}

Option allow_files_option(bool& any_file) {
  return {
      "--allow-files", "",
      "Let the preset inside an EXR or PNG name files anywhere. Otherwise it may name those beside the picture alone",
      &any_file};
}

std::string picture_name(const std::string& argument) {
  const std::string name = fs::path(argument).stem().string();
  const bool stream = argument == "-" || argument.starts_with("/dev/") || argument.starts_with("/proc/");
  return stream || name.empty() ? "sky" : name;
}

}  // namespace airlight::cli
