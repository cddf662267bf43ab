// "POINTER=JSON" from the command line, applied to a parsed preset.

#include <span>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/preset.h"
#include "core/scene/printable.h"
#include "core/scene/problems.h"

namespace airlight {
namespace {

// The keys of an RFC 6901 pointer, unescaped.
std::vector<std::string> split_pointer(std::string_view pointer, const std::string& source) {
  if (!pointer.starts_with('/')) {
    throw InputError(source + ": " + quoted_text(pointer) +
                     " is not a JSON pointer; expected a path such as /camera/pitch_deg");
  }
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    const char c = pointer[i];
    if (c == '/') {
      keys.emplace_back();
    } else if (c == '~') {
      const char escaped = i + 1 < pointer.size() ? pointer[i + 1] : '\0';
      if (escaped != '0' && escaped != '1') {
        throw InputError(source + ": " + quoted_text(pointer) +
                         " has a lone ~; expected ~0 for ~ and ~1 for / in a JSON pointer");
      }
      keys.back() += escaped == '0' ? '~' : '/';
      ++i;
    } else {
      keys.back() += c;
    }
  }
  return keys;
}

PresetValue& element(PresetArray& array, const std::string& key, const std::string& place) {
  const std::optional<std::size_t> index = number_from<std::size_t>(key);
  const bool is_index = index && (key.size() == 1 || !key.starts_with('0'));
  if (!is_index || *index >= array.size()) {
    const std::string range =
        array.empty() ? "none: it is empty" : "an index from 0 to " + std::to_string(array.size() - 1);
    throw InputError(place + ": there is no element " + quoted_text(key) + "; expected " + range);
  }
  return array[*index];
}

// The value that the pointer leads to. Missing keys are made on the way, so that a preset may omit an object.
// A list is not made: its elements would lack what they need.
PresetValue& descend(PresetValue& root, std::span<const std::string> keys, const std::string& source) {
  PresetValue* at = &root;
  std::string pointer;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string& key = keys[i];
    const std::string parent = pointer;
    pointer = pointer_below(pointer, key);
    if (auto* object = std::get_if<PresetObject>(&at->data)) {
      const auto [place, is_new] = object->try_emplace(key);
      if (is_new && i + 1 < keys.size() && number_from<std::size_t>(keys[i + 1])) {
        throw InputError(source + ": " + shown_pointer(pointer) + ": the preset has none, so there is no element " +
                         quoted_text(keys[i + 1]) + "; set the whole list: " + shown_pointer(pointer) + "=[...]");
      }
      if (is_new) {
        place->second.data = PresetObject{};
        place->second.source = source;
      }
      at = &place->second;
    } else if (auto* array = std::get_if<PresetArray>(&at->data)) {
      at = &element(*array, key, source + ": " + shown_pointer(pointer));
    } else {
      throw InputError(source + ": " + shown_pointer(pointer) + ": " +
                       (parent.empty() ? "the preset" : shown_pointer(parent)) +
                       " is a single value and has no keys; expected a pointer to a key of format 1");
    }
  }
  return *at;
}

// Another method chosen on the command line extends the file as `extends` does: parameters that the file sets for its
// own method are no error.
void release_render_keys(Preset& preset) {
  auto& render = std::get<PresetObject>(std::get<PresetObject>(preset.root.data).at("render").data);
  for (auto& [key, value] : render) {
    value.inherited = value.inherited || value.line > 0;
  }
}

}  // namespace

const PresetValue* find_value(const PresetValue& root, std::string_view pointer) {
  const PresetValue* at = &root;
  for (const std::string& key : pointer.empty() ? std::vector<std::string>() : split_pointer(pointer, "preset")) {
    const auto* array = at == nullptr ? nullptr : std::get_if<PresetArray>(&at->data);
    const std::size_t index = array == nullptr ? 0 : number_from<std::size_t>(key).value_or(array->size());
    at = array == nullptr ? member(at, key) : index < array->size() ? &(*array)[index] : nullptr;
  }
  return at;
}

void put_value(Preset& preset, std::string_view pointer, PresetValue value, const std::string& source) {
  descend(preset.root, split_pointer(pointer, source), source) = std::move(value);
}

void apply_override(Preset& preset, std::string_view assignment) {
  apply_override(preset, assignment, "--set " + shortened(assignment));
}

void apply_override(Preset& preset, std::string_view assignment, const std::string& source) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw InputError(source + ": no '='; expected POINTER=JSON, e.g. /camera/pitch_deg=20");
  }
  const std::string_view pointer = assignment.substr(0, equals);
  const std::string_view text = assignment.substr(equals + 1);
  split_pointer(pointer, source);  // a bad pointer is reported before a bad value
  PresetValue value;
  if (std::optional<PresetValue> parsed = try_parse_json_value(text, source)) {
    value = *std::move(parsed);
  } else if (try_parse_json_value(json_string(text), source)) {
    value.data = std::string(text);
    value.source = source;
  } else {
    throw InputError(source + ": the value is neither JSON nor UTF-8 text; expected POINTER=JSON");
  }
  put_value(preset, pointer, std::move(value), source);
  if (pointer == "/render/method") {
    release_render_keys(preset);
  }
}

}  // namespace airlight
