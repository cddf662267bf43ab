#include "app/cli/carried_preset.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/library/embedded_presets.h"
#include "core/scene/curve_reader.h"
#include "core/scene/json_text.h"
#include "core/scene/printable.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

// Keys whose texts name files, wherever they stand.
constexpr std::array<std::string_view, 4> kFileKeys{"file", "albedo_map", "mask_map", "height_map"};

class Fence {
 public:
  Fence(std::string name, const fs::path& folder)
      : name_(std::move(name)), folder_(fs::weakly_canonical(folder.empty() ? fs::path(".") : folder)) {}

  // Links count as what they lead to.
  void require_inside(const fs::path& file, const std::string& pointer, const std::string& text) const {
    std::error_code problem;
    const fs::path real = fs::weakly_canonical(file, problem);
    const auto [rest, ignored] = std::mismatch(folder_.begin(), folder_.end(), real.begin(), real.end());
    if (problem || rest != folder_.end()) {
      throw InputError(name_ + ": " + pointer + ": " + quoted_text(text) +
                       " is outside of the picture's folder; a preset inside a picture may name files beside it alone: "
                       "give --allow-files if you trust who made it");
    }
  }

  void check(const PresetValue& value, const std::string& pointer) const {
    if (const auto* array = std::get_if<PresetArray>(&value.data)) {
      for (std::size_t i = 0; i < array->size(); ++i) {
        check((*array)[i], pointer_below(pointer, std::to_string(i)));
      }
    }
    if (const auto* object = std::get_if<PresetObject>(&value.data)) {
      for (const auto& [key, child] : *object) {
        const std::string here = pointer_below(pointer, key);
        const auto* text = std::get_if<std::string>(&child.data);
        if (text != nullptr && !text->empty() && std::ranges::find(kFileKeys, key) != kFileKeys.end()) {
          require_inside(key == "file" ? file_beside(child, *text) : fs::path(*text), here, *text);
        }
        check(child, here);
      }
    }
  }

 private:
  std::string name_;
  fs::path folder_;
};

}  // namespace

Preset carried_preset(const Provenance& picture, const std::string& name, const fs::path& folder, bool any_file) {
  const Fence fence(name, folder);
  if (!any_file) {
    const std::optional<PresetValue> root = try_parse_json_value(picture.preset_json, name);
    const PresetValue* const object = root ? &*root : nullptr;
    const auto* base = member_as<std::string>(object, "extends");
    const bool built_in =
        base != nullptr && (embedded_presets().contains(*base) || embedded_presets().contains(*base + ".json"));
    if (base != nullptr && !built_in) {
      fence.require_inside(folder / *base, "/extends", *base);
    }
  }
  Preset preset = parse_preset(picture.preset_json, name, folder, embedded_presets());
  if (!any_file) {
    fence.check(preset.root, "");
  }
  preset.version = picture.version;
  return preset;
}

}  // namespace airlight::cli
