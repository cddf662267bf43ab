#pragma once
// JSON text <-> Preset: a tree of values that remember where they came from. The only part that knows the JSON library.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/scene.h"

namespace airlight {

struct PresetValue;
using PresetArray = std::vector<PresetValue>;
using PresetObject = std::map<std::string, PresetValue, std::less<>>;

struct PresetValue {
  std::variant<std::monostate, bool, double, std::string, PresetArray, PresetObject> data;
  std::string source;      // file name, or the option that set it
  int line = 0;            // 0: no line (an option)
  bool inherited = false;  // came from a file named by `extends`
};

// What stands under a key; null where nothing does, or `value` is null or no object.
template <class Value>
Value* member(Value* value, std::string_view key) {
  auto* object = value == nullptr ? nullptr : std::get_if<PresetObject>(&value->data);
  const auto found = object == nullptr ? decltype(object->find(key))() : object->find(key);
  return object == nullptr || found == object->end() ? nullptr : &found->second;
}

// The same where it is a T.
template <class T, class Value>
auto* member_as(Value* value, std::string_view key) {
  Value* found = member(value, key);
  return found == nullptr ? nullptr : std::get_if<T>(&found->data);
}

struct Preset {
  std::string source;  // as the user named it
  PresetValue root;
};

// Presets that are not on disk: file name -> text.
using BundledPresets = std::map<std::string, std::string_view, std::less<>>;

// Reads a file and everything it extends; `media` merge by name, other objects key by key. What `extends` names is a
// file, by a path relative to the one that names it, or else by its bare name ("earth") one of `bundled`.
// Throws InputError: missing file, syntax (line and column), duplicate key, `extends` cycle.
Preset load_preset(const std::filesystem::path& file, const BundledPresets& bundled = {});

// The same from text; `base` is the folder that `extends` is relative to.
Preset parse_preset(std::string_view text, std::string_view source, const std::filesystem::path& base,
                    const BundledPresets& bundled = {});

// A preset of the bundle, whose `extends` names files of the bundle.
Preset parse_bundled_preset(const std::string& file, const BundledPresets& bundled);

// Applies "POINTER=JSON" (RFC 6901 pointer, e.g. /camera/pitch_deg=20). A value that is not JSON is taken as a string.
// Throws InputError when the pointer is malformed or leads through something that is not an object or array.
// Messages name `source`, the option as typed; without it "--set ASSIGNMENT".
void apply_override(Preset& preset, std::string_view assignment);
void apply_override(Preset& preset, std::string_view assignment, const std::string& source);

// Puts a value where an RFC 6901 pointer leads, making the objects on the way. Throws InputError as apply_override
// does; `source` says in messages who asks.
void put_value(Preset& preset, std::string_view pointer, PresetValue value, const std::string& source);

// How an exposure that is no number is metered, as a preset spells it: "auto", "day", "lock:12".
std::string metering_text(const Display& display);

// The whole scene as a preset of format 1, every key written out, so that resolving it again gives the same scene.
std::string to_json(const Scene& scene);

}  // namespace airlight
