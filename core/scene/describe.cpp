// describe: a scene as people read it, one value a line with its unit. Names and units are those of the rules.

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/printable.h"
#include "core/scene/render_settings.h"
#include "core/scene/resolve.h"
#include "core/scene/rules.h"

namespace airlight {
namespace {

constexpr std::size_t kLongestValue = 300;  // bytes
constexpr std::size_t kMostOfAList = 20;
constexpr std::size_t kMostInALine = 5;  // values of an object; one with more gets a heading of its own

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : text + " " + std::string(unit);
}

std::string text_of(const PresetValue& value);

std::string list_text(const PresetArray& array) {
  if (array.size() > kMostOfAList) {
    return std::to_string(array.size()) + " values, " + text_of(array.front()) + " to " + text_of(array.back());
  }
  const bool is_spectrum = array.size() == 3 && std::holds_alternative<double>(array.front().data);
  std::string text;
  for (const PresetValue& element : array) {
    text += (text.empty() ? "" : is_spectrum ? " " : ", ") + text_of(element);
  }
  return is_spectrum ? text : "[" + text + "]";
}

// A curve over the wavelength by its range, another object by its keys.
std::string object_text(const PresetObject& object) {
  const auto found = object.find("wavelengths_nm");
  const auto* nm = found == object.end() ? nullptr : std::get_if<PresetArray>(&found->second.data);
  if (nm != nullptr && !nm->empty()) {
    return std::to_string(nm->size()) + " samples, " + text_of(nm->front()) + " to " + text_of(nm->back()) + " nm";
  }
  std::string text;
  for (const auto& [key, value] : object) {
    text += (text.empty() ? "" : ", ") + key + " " + text_of(value);
  }
  return text;
}

std::string text_of(const PresetValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) {
    return format_number(*number);
  }
  if (const auto* flag = std::get_if<bool>(&value.data)) {
    return *flag ? "yes" : "no";
  }
  if (const auto* text = std::get_if<std::string>(&value.data)) {
    return text->empty() ? "\"\"" : *text;
  }
  const auto* array = std::get_if<PresetArray>(&value.data);
  return array != nullptr ? list_text(*array) : object_text(std::get<PresetObject>(value.data));
}

// "scale height" of scale_height_km, whose unit follows the value.
std::string label_of(std::string_view key, std::string_view unit) {
  const auto replaced = [](std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
    return text;
  };
  const std::string full = unit == "degrees" ? "deg" : unit == "stops" ? "ev" : std::string(unit);
  for (const std::string_view slash : {"_per_", "_"}) {
    const std::string end = "_" + replaced(replaced(full, "/", slash), " ", "_");
    if (!unit.empty() && key.ends_with(end)) {
      key.remove_suffix(end.size());
      break;
    }
  }
  return replaced(std::string(key), "_", " ");
}

class Description {
 public:
  void heading(const std::string& name) { text_ += name + "\n"; }

  void line(std::string name, const std::string& value) {
    constexpr std::size_t kValueColumn = 26;
    name.resize(std::max(name.size() + 1, kValueColumn), ' ');
    text_ += "  " + name + value + "\n";
  }

  // The values of one object; below them the objects in it that are too long for a line. `prefix`: the rules' name of
  // it; `name`: that of this one.
  void object(const std::string& name, const PresetObject& object, const std::string& prefix) {
    const std::size_t before = text_.size();
    std::vector<std::pair<std::string, const PresetValue*>> below;
    for (const auto& [rule, key] : keys_of(object, prefix)) {
      const PresetValue& value = object.find(key)->second;
      const bool is_leaf = path_within(*rule, prefix) == key;
      if (is_leaf && rule->type != RuleType::media && rule->type != RuleType::clouds &&
          rule->type != RuleType::spheres) {
        line(label_of(key, rule->unit), with_unit(shortened(text_of(value), kLongestValue), rule->unit));
      } else if (const std::string text = prefix.empty() ? "" : in_a_line(value, prefix + "." + key); !text.empty()) {
        line(label_of(key, {}), text);
      } else {
        below.emplace_back(key, &value);
      }
    }
    if (!name.empty() && text_.size() > before) {
      text_.insert(before, name + "\n");
    }
    for (const auto& [key, value] : below) {
      all((name.empty() ? "" : name + ".") + key, *value, (prefix.empty() ? "" : prefix + ".") + key);
    }
  }

  // The keys of the method, below those of all methods.
  void parameters(const RenderSettings& render) {
    for (const auto& [key, value] : render.parameters) {
      const std::string text = json_text(value);
      line(key, text.empty() ? "absent" : text);
    }
  }

  const std::string& str() const { return text_; }

 private:
  // The first rule of each key that the object has, in the rules' order.
  static std::vector<std::pair<const Rule*, std::string>> keys_of(const PresetObject& object,
                                                                  const std::string& prefix) {
    std::vector<std::pair<const Rule*, std::string>> keys;
    std::set<std::string, std::less<>> seen;
    for (const Rule& rule : rules()) {
      const std::string_view path = path_within(rule, prefix);
      const std::string key(path.substr(0, path.find_first_of(".[")));
      if (object.contains(key) && seen.insert(key).second) {
        keys.emplace_back(&rule, key);
      }
    }
    return keys;
  }

  // "exponential, scale height 8 km"; empty where it does not fit in a line.
  static std::string in_a_line(const PresetValue& value, const std::string& prefix) {
    const auto* object = std::get_if<PresetObject>(&value.data);
    if (object == nullptr || object->size() > kMostInALine) {
      return {};
    }
    std::string text;
    for (const auto& [rule, key] : keys_of(*object, prefix)) {
      const std::string what = with_unit(shortened(text_of(object->find(key)->second), kLongestValue), rule->unit);
      const bool names_the_object = rule->type == RuleType::choice && text.empty();
      text += (text.empty() ? "" : ", ") + (names_the_object ? what : label_of(key, rule->unit) + " " + what);
    }
    return text;
  }

  void all(const std::string& name, const PresetValue& value, const std::string& prefix) {
    if (const auto* whole = std::get_if<PresetObject>(&value.data)) {
      object(name, *whole, prefix);
    } else if (const auto* array = std::get_if<PresetArray>(&value.data)) {
      for (std::size_t i = 0; i < array->size(); ++i) {
        all(name + "[" + std::to_string(i) + "]", (*array)[i], prefix + "[]");
      }
    }
  }

  std::string text_;
};

// What follows from the preset and does not stand in it.
void add_derived(Description& lines, const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> derived;
  if (scene.sun.disc.cover) {
    derived.emplace_back("sun beside the moon", format_number(scene.sun.uncovered) + " of its light");
  }
  if (scene.moon) {
    const Spectrum& e = scene.moon->irradiance;
    derived.emplace_back("moon's irradiance",
                         format_number(e[0]) + " " + format_number(e[1]) + " " + format_number(e[2]));
  }
  for (const Cloud& cloud : scene.clouds) {
    if (cloud.voxels) {
      derived.emplace_back("cloud's base and top",
                           format_number(cloud.base) + " to " + format_number(cloud.top) + " km");
    }
  }
  if (!derived.empty()) {
    lines.heading("what follows from these");
  }
  for (const auto& [name, value] : derived) {
    lines.line(name, value);
  }
}

}  // namespace

std::string describe(const Scene& scene) {
  Preset preset = parse_preset(to_json(scene), scene.name, {});
  auto& root = std::get<PresetObject>(preset.root.data);
  Description lines;
  if (!scene.name.empty()) {
    lines.heading(scene.name + (scene.description.empty() ? "" : ": " + scene.description));
  }
  const PresetObject render = std::get<PresetObject>(root.at("render").data);
  for (const char* key : {"airlight", "name", "description", "render"}) {
    root.erase(key);
  }
  lines.object("", root, "");
  lines.object("render", render, "render");
  lines.parameters(scene.render);
  add_derived(lines, scene);
  return lines.str();
}

}  // namespace airlight
