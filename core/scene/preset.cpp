#include "core/scene/preset.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/json_text.h"
#include "core/scene/named_file.h"
#include "core/scene/printable.h"
#include "core/scene/suggestion.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

std::string place_of(const PresetValue& value) {
  std::string place = value.source;
  if (value.line > 0) {
    place.append(":").append(std::to_string(value.line));
  }
  return place;
}

PresetValue parse_root(std::string_view text, std::string_view source) {
  PresetValue root = parse_json_text(text, source);
  if (!std::holds_alternative<PresetObject>(root.data)) {
    throw InputError(place_of(root) + ": not an object; expected {\"airlight\": 1, ...}");
  }
  return root;
}

void mark_inherited(PresetValue& value) {
  value.inherited = true;
  if (auto* array = std::get_if<PresetArray>(&value.data)) {
    std::ranges::for_each(*array, mark_inherited);
  } else if (auto* object = std::get_if<PresetObject>(&value.data)) {
    for (auto& [key, child] : *object) {
      mark_inherited(child);
    }
  }
}

void merge_object(PresetValue& base, PresetValue&& over);

// A density with a profile of its own replaces the inherited one whole: the old profile's keys would not apply.
bool replaces_whole(std::string_view key, const PresetValue& over) {
  const auto* object = std::get_if<PresetObject>(&over.data);
  // A curve over the wavelength is one value.
  const bool is_curve =
      key == "scattering_per_km" || key == "absorption_per_km" || key == "ground_albedo" || key == "spectrum";
  return object == nullptr || is_curve || (key == "density" && object->contains("profile"));
}

// Media of the same name merge, the others are added in order. A name's second entry in `over` is added as well, so
// that resolve() finds the duplicate.
void merge_media(PresetArray& base, PresetArray&& over) {
  std::vector<bool> merged(base.size(), false);
  for (PresetValue& medium : over) {
    const std::string* name = member_as<std::string>(&medium, "name");
    const auto same = std::ranges::find_if(base, [&](const PresetValue& inherited) {
      const std::string* inherited_name = member_as<std::string>(&inherited, "name");
      return name != nullptr && inherited_name != nullptr && *name == *inherited_name;
    });
    const auto index = static_cast<std::size_t>(same - base.begin());
    if (index < merged.size() && !merged[index]) {
      merged[index] = true;
      merge_object(*same, std::move(medium));
    } else {
      base.push_back(std::move(medium));
    }
  }
}

// A phase function of its own keeps only g of the inherited one: the others' keys would not apply.
void drop_other_function(PresetObject& base, const PresetValue& over) {
  if (std::get<PresetObject>(over.data).contains("function")) {
    std::erase_if(base, [](const auto& entry) { return entry.first != "g"; });
  }
}

// The version of a file of another format is kept, so that it is an error in the file that extends it, too.
bool is_foreign_version(std::string_view key, const PresetValue& base) {
  const auto* version = std::get_if<double>(&base.data);
  return key == "airlight" && (version == nullptr || *version != 1.0);
}

void merge_object(PresetValue& base, PresetValue&& over) {
  auto& base_object = std::get<PresetObject>(base.data);
  base.source = over.source;
  base.line = over.line;
  base.inherited = over.inherited;
  for (auto& [key, value] : std::get<PresetObject>(over.data)) {
    const auto [place, is_new] = base_object.try_emplace(key);
    PresetValue& target = place->second;
    if (!is_new && is_foreign_version(key, target)) {
      continue;
    }
    const bool both_objects =
        std::holds_alternative<PresetObject>(target.data) && std::holds_alternative<PresetObject>(value.data);
    const bool both_arrays =
        std::holds_alternative<PresetArray>(target.data) && std::holds_alternative<PresetArray>(value.data);
    if (!is_new && both_objects && !replaces_whole(key, value)) {
      if (key == "phase") {
        drop_other_function(std::get<PresetObject>(target.data), value);
      }
      merge_object(target, std::move(value));
    } else if (!is_new && both_arrays && key == "media") {
      merge_media(std::get<PresetArray>(target.data), std::move(std::get<PresetArray>(value.data)));
      target.source = value.source;
      target.line = value.line;
      target.inherited = value.inherited;
    } else {
      target = std::move(value);
    }
  }
}

void find_file(PresetValue* object, std::string_view key, const fs::path& folder) {
  auto* name = member_as<std::string>(object, key);
  if (name != nullptr && !name->empty()) {
    *name = (folder / *name).lexically_normal().string();
  }
}

// Makes names of files in a preset relative to the preset's folder, wherever the program runs.
void find_files(PresetValue& root, const fs::path& folder) {
  PresetValue* planet = member(&root, "planet");
  find_file(planet, "albedo_map", folder);
  find_file(member(planet, "ocean"), "mask_map", folder);
  find_file(member(planet, "terrain"), "height_map", folder);
  find_file(member(planet, "terrain"), "albedo_map", folder);
}

// The file that `root` extends. The key is removed if it names one; resolve() refuses a wrong type.
struct Extension {
  std::string name;
  std::string place;  // FILE:LINE: /extends
};

bool take_extension(PresetValue& root, Extension& extension) {
  auto& object = std::get<PresetObject>(root.data);
  const auto key = object.find("extends");
  if (key == object.end() || !std::holds_alternative<std::string>(key->second.data)) {
    return false;
  }
  extension.name = std::get<std::string>(key->second.data);
  extension.place = place_of(key->second) + ": /extends: " + quoted_text(extension.name);
  object.erase(key);
  return true;
}

fs::path identity(const fs::path& file) {
  std::error_code error;
  fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file.lexically_normal() : canonical;
}

// One preset of a chain: a text on disk, or one of the bundle.
struct Link {
  std::string text;
  std::string source;  // for messages
  fs::path folder;     // that `extends` is relative to
  bool bundled = false;
  fs::path id;  // empty: a text without a file
};

constexpr std::string_view kBundled = "built-in preset ";  // before a file's name in messages

Link bundled_link(const std::string& file, std::string_view text) {
  return {.text = std::string(text), .source = file, .folder = {}, .bundled = true, .id = std::string(kBundled) + file};
}

// The link that `extends` names, seen from the link with the `extends`.
Link follow(const Link& from, const Extension& extension, const BundledPresets& bundled) {
  const bool bare = extension.name.find('/') == std::string::npos;
  const bool has_ending = extension.name.ends_with(".json");
  const auto known = bundled.find(has_ending ? extension.name : extension.name + ".json");
  if (from.bundled && known != bundled.end()) {
    return bundled_link(known->first, known->second);
  }
  const fs::path file = (from.folder / extension.name).lexically_normal();
  std::error_code ignored;
  const bool on_disk = fs::exists(file, ignored);
  if (!on_disk && bare && known != bundled.end()) {
    return bundled_link(known->first, known->second);
  }
  const NamedText read = read_named_text(file);
  if (read.problem.empty()) {
    return {.text = read.text,
            .source = file.string(),
            .folder = file.parent_path(),
            .bundled = false,
            .id = identity(file)};
  }
  std::string message =
      extension.place + " cannot be read: " + printable(shortened(file.string())) + ": " + read.problem;
  std::vector<std::string> names;
  for (const auto& [name, text] : bundled) {
    names.push_back(fs::path(name).stem().string());
  }
  if (!on_disk && bare && !bundled.empty()) {
    const auto nearest = nearest_name(fs::path(extension.name).stem().string(), names);
    message += ", and no built-in preset is called so" + (nearest ? "; did you mean \"" + *nearest + "\"?" : "") +
               (nearest ? "" : " (" + joined(names) + ")");
  }
  throw InputError(message + "; expected a preset, by a path relative to the file that names it" +
                   (bundled.empty() ? "" : ", or a built-in one by its name"));
}

// Follows `extends` from the user's text to the file that extends none, then merges backward.
Preset load_chain(Link link, const BundledPresets& bundled) {
  const std::string source = link.source;
  std::vector<PresetValue> chain;
  std::vector<fs::path> seen{link.id};
  chain.push_back(parse_root(link.text, link.source));
  find_files(chain.back(), link.folder);
  std::string route = printable(source);
  Extension extension;
  while (take_extension(chain.back(), extension)) {
    link = follow(link, extension, bundled);
    route += " -> " + printable(shortened(link.source));
    if (std::ranges::find(seen, link.id) != seen.end()) {
      throw InputError(extension.place + " makes a circle (" + route + "); a preset cannot build on itself");
    }
    seen.push_back(link.id);
    chain.push_back(parse_root(link.text, link.source));
    find_files(chain.back(), link.folder);
  }
  PresetValue root = std::move(chain.back());
  for (std::size_t i = chain.size() - 1; i > 0; --i) {
    mark_inherited(root);
    merge_object(root, std::move(chain[i - 1]));
  }
  return {.source = source, .root = std::move(root)};
}

}  // namespace

Preset load_preset(const fs::path& file, const BundledPresets& bundled) {
  const NamedText read = read_named_text(file);
  if (!read.problem.empty()) {
    throw InputError(file.string() + ": cannot be read: " + read.problem + "; expected a preset (a JSON file)");
  }
  return load_chain({.text = read.text,
                     .source = file.string(),
                     .folder = file.parent_path(),
                     .bundled = false,
                     .id = identity(file)},
                    bundled);
}

Preset parse_preset(std::string_view text, std::string_view source, const fs::path& base,
                    const BundledPresets& bundled) {
  return load_chain(
      {.text = std::string(text), .source = std::string(source), .folder = base, .bundled = false, .id = {}}, bundled);
}

Preset parse_bundled_preset(const std::string& file, const BundledPresets& bundled) {
  return load_chain(bundled_link(file, bundled.find(file)->second), bundled);
}

}  // namespace airlight
