#include "app/cli/preset_source.h"

#include <filesystem>
#include <iostream>
#include <iterator>

#include "app/cli/embedded_presets.h"
#include "app/cli/suggest.h"
#include "core/error.h"
#include "core/output/provenance.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".json";

Preset from_standard_input() {
  const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  return parse_preset(text, "standard input", fs::current_path());
}

Preset built_in(const std::string& name) {
  const auto found = embedded_presets().find(name + std::string(kEnding));
  if (found == embedded_presets().end()) {
    throw InputError("no preset '" + name + "': neither a file nor a built-in preset of that name" +
                     did_you_mean(name, built_in_names()) + "; 'airlight presets' lists the built-in ones");
  }
  return parse_preset(found->second, found->first, {}, embedded_presets());
}

bool is_bare_name(const std::string& argument) {
  return argument.find('/') == std::string::npos && !argument.ends_with(kEnding);
}

}  // namespace

Preset find_preset(const std::string& argument) {
  if (argument == "-") {
    return from_standard_input();
  }
  std::error_code error;
  const bool is_file = fs::exists(argument, error) && !fs::is_directory(argument, error);
  if (!is_file && is_bare_name(argument)) {
    return built_in(argument);
  }
  if (is_exr(argument)) {
    return parse_preset(read_provenance(argument).preset_json, argument, fs::path(argument).parent_path());
  }
  return load_preset(argument);
}

std::vector<std::string> built_in_names() {
  std::vector<std::string> names;
  for (const auto& [file, text] : embedded_presets()) {
    names.push_back(file.substr(0, file.size() - kEnding.size()));
  }
  return names;
}

std::string picture_name(const std::string& argument) {
  const std::string name = fs::path(argument).stem().string();
  return argument == "-" || name.empty() ? "sky" : name;
}

}  // namespace airlight::cli
