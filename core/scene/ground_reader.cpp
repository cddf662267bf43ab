#include "core/scene/ground_reader.h"

#include <filesystem>
#include <string>

namespace airlight {
namespace {

std::string absolute_name(const std::string& name) {
  return name.empty() ? name : std::filesystem::absolute(name).lexically_normal().string();
}

}  // namespace

std::optional<GroundMap> read_ground_map(const Section& root) {
  const PresetValue* there = root.find("planet");
  if (there == nullptr || !std::holds_alternative<PresetObject>(there->data)) {
    return std::nullopt;
  }
  const Section planet = root.child("planet");
  GroundMap map;
  map.albedo_map = absolute_name(planet.text("albedo_map"));
  if (planet.find("ocean") != nullptr) {
    const Section section = planet.child("ocean");
    section.refuse_unknown_keys();
    map.ocean = Ocean{section.number("wind_m_per_s"), absolute_name(section.text("mask_map"))};
  }
  return map.albedo_map.empty() && !map.ocean ? std::nullopt : std::optional(map);
}

}  // namespace airlight
