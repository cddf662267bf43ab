#include "core/library/built_in.h"

#include <optional>

#include "core/base/error.h"
#include "core/library/embedded_presets.h"
#include "core/scene/suggestion.h"

namespace airlight {
namespace {

constexpr std::string_view kEnding = ".json";

}  // namespace

std::vector<std::string> built_in_names() {
  std::vector<std::string> names;
  for (const auto& [file, text] : embedded_presets()) {
    names.push_back(file.substr(0, file.size() - kEnding.size()));
  }
  return names;
}

bool is_built_in(const std::string& name) {
  return embedded_presets().contains(name + std::string(kEnding));
}

Preset built_in_preset(const std::string& name, const std::string& listed_by) {
  if (!is_built_in(name)) {
    throw InputError("no preset '" + name + "': neither a file nor a built-in preset of that name" +
                     suggested(name, built_in_names()) + "; " + listed_by + " lists the built-in ones");
  }
  return parse_bundled_preset(name + std::string(kEnding), embedded_presets());
}

std::string suggested(const std::string& word, const std::vector<std::string>& names) {
  const std::optional<std::string> nearest = nearest_name(word, names);
  return nearest ? " (did you mean '" + *nearest + "'?)" : std::string();
}

}  // namespace airlight
