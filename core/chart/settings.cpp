#include "core/chart/settings.h"

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/scene/json_text.h"

namespace airlight::chart {
namespace {

[[noreturn]] void refuse(const PresetValue& value, std::string_view key, const std::string& expected) {
  throw InputError(value.source + ":" + std::to_string(value.line) + ": /" + std::string(key) + ": expected " +
                   expected);
}

const PresetValue& member(const PresetValue& root, std::string_view key) {
  const auto& object = std::get<PresetObject>(root.data);
  const auto found = object.find(key);
  if (found == object.end()) {
    refuse(root, key, "this key: a chart's list has scenes, image, compared_pixels and truth_error");
  }
  return found->second;
}

std::array<int, 2> two_sides(const PresetValue& root, std::string_view key, int largest) {
  const std::string expected = "[width, height], whole numbers from 1 to " + std::to_string(largest);
  const PresetValue& value = member(root, key);
  const auto* list = std::get_if<PresetArray>(&value.data);
  if (list == nullptr || list->size() != 2) {
    refuse(value, key, expected);
  }
  std::array<int, 2> sides{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto* number = std::get_if<double>(&(*list)[i].data);
    if (number == nullptr || !(*number >= 1.0 && *number <= largest) || *number != std::floor(*number)) {
      refuse((*list)[i], key, expected);
    }
    sides[i] = static_cast<int>(*number);
  }
  return sides;
}

}  // namespace

Settings parse_settings(std::string_view text, std::string_view source) {
  const PresetValue root = parse_json_text(text, source);
  if (!std::holds_alternative<PresetObject>(root.data)) {
    refuse(root, "", "an object");
  }
  for (const auto& [key, value] : std::get<PresetObject>(root.data)) {
    if (key != "scenes" && key != "image" && key != "compared_pixels" && key != "truth_error") {
      refuse(value, key, "no such key: a chart's list has scenes, image, compared_pixels and truth_error");
    }
  }
  Settings settings;
  const PresetValue& scenes = member(root, "scenes");
  const auto* list = std::get_if<PresetArray>(&scenes.data);
  if (list == nullptr || list->empty()) {
    refuse(scenes, "scenes", "an array of names of presets");
  }
  for (const PresetValue& scene : *list) {
    const auto* name = std::get_if<std::string>(&scene.data);
    if (name == nullptr) {
      refuse(scene, "scenes", "names of presets");
    }
    settings.scenes.push_back(*name);
  }
  const std::array<int, 2> image = two_sides(root, "image", 16384);
  settings.image = {image[0], image[1]};
  const std::array<int, 2> compared = two_sides(root, "compared_pixels", 1024);
  settings.compared_columns = compared[0];
  settings.compared_rows = compared[1];
  const PresetValue& error = member(root, "truth_error");
  const auto* number = std::get_if<double>(&error.data);
  if (number == nullptr || !(*number > 0.0 && *number < 1.0)) {
    refuse(error, "truth_error", "a relative error above 0 and below 1, such as 0.001");
  }
  settings.truth_error = *number;
  return settings;
}

}  // namespace airlight::chart
