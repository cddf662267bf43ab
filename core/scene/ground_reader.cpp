#include <filesystem>
#include <string>

#include "core/scene/json_format.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

std::string absolute(const std::string& name) {
  return name.empty() ? name : std::filesystem::absolute(name).lexically_normal().string();
}

void require_one_source(const Section& planet, const Section& section, const Terrain& terrain) {
  const PresetValue& place = *planet.find("terrain");
  for (const char* key : {"lowest_km", "highest_km"}) {
    if (terrain.ridge && section.find(key) != nullptr) {
      section.complain(key, *section.find(key), "belongs to a height_map; a ridge has height_km: remove it");
    }
  }
  if (terrain.ridge && !terrain.height_map.empty()) {
    section.complain("ridge", *section.find("ridge"),
                     "there is a height_map beside it; expected one of the two: remove the other");
  } else if (!terrain.ridge && terrain.height_map.empty()) {
    planet.complain("terrain", place,
                    "has no heights; expected \"height_map\": \"FILE\" or \"ridge\": {\"seed\": 1, \"height_km\": 2}");
  }
}

// Refuses a map too far away: it is laid on the sphere around the camera and would otherwise meet itself.
void require_near(const Section& section, const Terrain& terrain, const Planet& on) {
  constexpr double kMost = 0.3;  // of the radius
  const double reach = terrain.distance + 0.75 * terrain.width;
  if (reach > kMost * on.ground_radius) {
    const PresetValue* at = section.find("distance_km");
    const char* key = at != nullptr ? "distance_km" : "width_km";
    section.complain(key, at != nullptr ? *at : *section.find("width_km"),
                     "the map reaches " + format_number(reach) +
                         " km from the camera; expected at most 0.3 radii of "
                         "the planet, " +
                         format_number(kMost * on.ground_radius) + " km: bring it nearer or make it smaller");
  }
}

}  // namespace

std::optional<Terrain> read_terrain(const Section& planet, const Planet& on) {
  if (planet.find("terrain") == nullptr) {
    return std::nullopt;
  }
  const Section section = planet.child("terrain");
  section.refuse_unknown_keys();
  Terrain terrain;
  section.fill(terrain);
  terrain.height_map = absolute(terrain.height_map);
  terrain.albedo_map = absolute(terrain.albedo_map);
  if (section.find("ridge") != nullptr) {
    const Section ridge = section.child("ridge");
    ridge.refuse_unknown_keys();
    ridge.fill(terrain.ridge.emplace());
  }
  if (section.object() != nullptr) {
    require_one_source(planet, section, terrain);
    if (section.find("width_km") != nullptr) {
      require_near(section, terrain, on);
    }
  }
  return terrain;
}

std::optional<GroundMap> read_ground_map(const Section& planet) {
  GroundMap map;
  planet.fill(map);
  map.albedo_map = absolute(map.albedo_map);
  if (planet.find("ocean") != nullptr) {
    const Section section = planet.child("ocean");
    section.refuse_unknown_keys();
    section.fill(map.ocean.emplace());
    map.ocean->mask_map = absolute(map.ocean->mask_map);
  }
  return map.albedo_map.empty() && !map.ocean ? std::nullopt : std::optional(map);
}

}  // namespace airlight
