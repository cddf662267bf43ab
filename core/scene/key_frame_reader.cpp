#include <algorithm>
#include <cctype>
#include <set>

#include "core/scene/readers.h"

namespace airlight {
namespace {

constexpr std::string_view kAt = "at";

bool is_index(std::string_view part) {
  return !part.empty() && std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// "/media/0/phase/g" -> "media[].phase.g".
std::string rule_key(std::string_view pointer) {
  std::string key;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view part = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(part.size());
    key += is_index(part) ? "[]" : (key.empty() ? "" : ".") + std::string(part);
  }
  return key;
}

// Whether the key takes only whole numbers. No parameter takes whole numbers in one method and others in another.
bool is_whole(std::string_view pointer, std::span<const MethodInfo> methods) {
  const std::string key = rule_key(pointer);
  for (const Rule& rule : rules()) {
    if (rule.key == key) return rule.type == RuleType::integer;
  }
  for (const MethodInfo& method : methods) {
    for (const ParameterInfo& parameter : method.parameters) {
      const std::string name = "render." + std::string(parameter.key);
      if (key == name || key == name + "[]") {
        return parameter.kind == ParameterKind::integer || parameter.kind == ParameterKind::table_size;
      }
    }
  }
  return false;
}

// A number, or three; empty and reported when it is neither.
std::vector<double> read_values(const Section& section, const std::string& key, const PresetValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) {
    return {*number};
  }
  std::vector<double> values;
  if (const auto* array = std::get_if<PresetArray>(&value.data)) {
    for (const PresetValue& item : *array) {
      if (const auto* number = std::get_if<double>(&item.data)) values.push_back(*number);
    }
    if (values.size() == 3 && array->size() == 3) return values;
  }
  section.complain(key, value, quoted(value) + " cannot be animated; expected a number, or three of a spectrum");
  return {};
}

KeyFrame read_key_frame(const Section& section, const KeyFrames& earlier) {
  KeyFrame frame;
  frame.at = section.integer(kAt);
  const PresetValue* at = section.find(kAt);
  if (at != nullptr && !earlier.frames.empty() && frame.at <= earlier.frames.back().at) {
    section.complain(kAt, *at,
                     std::to_string(frame.at) + " is not above the frame before it (" +
                         std::to_string(earlier.frames.back().at) + "); expected ascending numbers");
  }
  if (section.object() == nullptr) return frame;
  for (const auto& [key, value] : *section.object()) {
    if (key == kAt) continue;
    if (!key.starts_with('/')) {
      section.complain(key, value, "unknown key; expected `at`, or a JSON pointer such as /sun/elevation_deg");
    } else if (key.starts_with("/sequence")) {
      section.complain(key, value, "a sequence cannot change itself; remove it");
    } else if (const std::vector<double> values = read_values(section, key, value); !values.empty()) {
      frame.values[key] = values;
    }
  }
  return frame;
}

}  // namespace

std::optional<KeyFrames> read_key_frames(const Section& root, std::span<const MethodInfo> methods) {
  if (root.find("sequence") == nullptr) return std::nullopt;
  const Section section = root.child("sequence");
  section.refuse_unknown_keys();
  section.choice("interpolation");
  KeyFrames sequence;
  const PresetValue* value = section.value_of("frames");
  if (value == nullptr) return sequence;
  const auto* array = std::get_if<PresetArray>(&value->data);
  if (array == nullptr || array->empty()) {
    section.complain("frames", *value,
                     (array == nullptr ? quoted(*value) + " is not an array" : "empty") + "; expected " +
                         expectation(section.rule("frames")));
    return sequence;
  }
  if (array->size() > kMostKeyFrames) {
    section.complain("frames", *value,
                     quoted(*value) + "; expected " + expectation(section.rule("frames")) +
                         ": leave out those that lie between others");
    return sequence;
  }
  std::set<std::string, std::less<>> seen;  // most frames have the same keys
  for (std::size_t i = 0; i < array->size(); ++i) {
    sequence.frames.push_back(read_key_frame(section.element("frames", *array, i), sequence));
    for (const auto& [pointer, values] : sequence.frames.back().values) {
      if (seen.insert(pointer).second && is_whole(pointer, methods)) sequence.whole.insert(pointer);
    }
  }
  return sequence;
}

void for_each_key_frame(const Preset& preset, const KeyFrames& sequence,
                        const std::function<void(const Preset&, const FrameValues&)>& use) {
  Preset base = preset;
  std::get<PresetObject>(base.root.data).erase("sequence");
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const std::string pointer = "/sequence/frames/" + std::to_string(i);
    const PresetValue& frame = *find_value(preset.root, pointer);
    const std::string place = frame.source + (frame.line > 0 ? ":" + std::to_string(frame.line) : "") + ": " + pointer;
    Preset then = base;
    for (const auto& [key, values] : sequence.frames[i].values) {
      put_value(then, key, *member(&frame, key), place);
    }
    use(then, {pointer, sequence.frames[i].values});
  }
}

}  // namespace airlight
