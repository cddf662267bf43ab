#pragma once
// JSON text <-> Preset: a tree of values that remember their source. Only this part knows the JSON library.

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

// The value under a key; null where there is none, or where `value` is null or no object.
template <class Value>
Value* member(Value* value, std::string_view key) {
  auto* object = value == nullptr ? nullptr : std::get_if<PresetObject>(&value->data);
  const auto found = object == nullptr ? decltype(object->find(key))() : object->find(key);
  return object == nullptr || found == object->end() ? nullptr : &found->second;
}

// The value under a key if it is a T.
template <class T, class Value>
auto* member_as(Value* value, std::string_view key) {
  Value* found = member(value, key);
  return found == nullptr ? nullptr : std::get_if<T>(&found->data);
}

struct Preset {
  std::string source;  // as the user named it
  PresetValue root;
  std::string version = {};  // of the airlight that wrote the picture which carries it; empty: none carries it
};

// Presets that are not on disk: file name -> text.
using BundledPresets = std::map<std::string, std::string_view, std::less<>>;

// Reads a file and everything it extends; `media` merge by name, other objects key by key. `extends` names a file by a
// path relative to the file that names it, or else one of `bundled` by its bare name ("earth"). Throws InputError:
// missing file, syntax (line and column), duplicate key, `extends` cycle.
Preset load_preset(const std::filesystem::path& file, const BundledPresets& bundled = {});

// The same for a text; `base` is the folder that `extends` is relative to.
Preset parse_preset(std::string_view text, std::string_view source, const std::filesystem::path& base,
                    const BundledPresets& bundled = {});

// A preset of the bundle, whose `extends` names files of the bundle.
Preset parse_bundled_preset(const std::string& file, const BundledPresets& bundled);

// Applies "POINTER=JSON" (RFC 6901 pointer, e.g. /camera/pitch_deg=20). A value that is not JSON is taken as a string.
// Throws InputError when the pointer is malformed or leads through something that is not an object or array. Messages
// name `source`, the option as typed; by default "--set ASSIGNMENT".
void apply_override(Preset& preset, std::string_view assignment);
void apply_override(Preset& preset, std::string_view assignment, const std::string& source);

// Puts a value at the place of an RFC 6901 pointer and makes objects on the way. Throws InputError as apply_override
// does; messages name `source`.
void put_value(Preset& preset, std::string_view pointer, PresetValue value, const std::string& source);

// The value at the place of an RFC 6901 pointer; null where there is none. Throws InputError for a malformed pointer.
const PresetValue* find_value(const PresetValue& root, std::string_view pointer);

// The metering of an exposure that is no number, in a preset's spelling: "auto", "day", "lock:12".
std::string metering_text(const Display& display);

// The whole scene as a preset of format 1 with every key written out; resolved again, it gives the same scene.
std::string to_json(const Scene& scene);

}  // namespace airlight
