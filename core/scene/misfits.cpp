#include <algorithm>

#include "core/member.h"
#include "core/scene/json_format.h"
#include "core/scene/readers.h"
#include "core/text.h"

namespace airlight {
namespace {

// The methods that support a feature, if the scene's does not; else empty.
std::string who_knows(const Scene& scene, MemberOf<MethodInfo, bool> knows, std::span<const MethodInfo> methods) {
  const bool known = std::ranges::any_of(
      methods, [&](const MethodInfo& method) { return method.name == scene.render.method && method.*knows; });
  return known ? "" : joined_of(methods, [&](const MethodInfo& method) {
    return method.*knows ? method.name : std::string_view();
  });
}

// Refuses spheres beside terrain, or with a method that does not support spheres.
void refuse_spheres_beside(const Section& root, const Scene& scene, std::span<const MethodInfo> methods) {
  const Section section = root.child("scene");
  const PresetValue& spheres = *section.find("spheres");
  if (const std::string names = who_knows(scene, &MethodInfo::knows_spheres, methods); !names.empty()) {
    section.complain("spheres", spheres,
                     "the method " + json_string(scene.render.method) + " knows no spheres; choose " + names +
                         " with render.method or --method, or remove the spheres");
  }
  if (scene.terrain) {
    section.complain("spheres", spheres,
                     "there is planet.terrain beside them, and neither would see the other; remove one of the two");
  }
}

// Refuses terrain with a method that does not support it.
void refuse_terrain_beside(const Section& root, const Scene& scene, std::span<const MethodInfo> methods) {
  if (const std::string names = who_knows(scene, &MethodInfo::knows_terrain, methods); !names.empty()) {
    const Section planet = root.child("planet");
    planet.complain("terrain", *planet.find("terrain"),
                    "the method " + json_string(scene.render.method) + " knows no terrain; choose " + names +
                        " with render.method or --method, or remove the terrain");
  }
}

// Refuses a ground by maps beside curves over the wavelength, terrain or spheres, or with a method that does not
// support it.
void refuse_ground_map_beside(const Section& root, const Scene& scene, bool curves,
                              std::span<const MethodInfo> methods) {
  const Section planet = root.child("planet");
  const char* key = planet.find("albedo_map") != nullptr ? "albedo_map" : "ocean";
  const auto complain = [&](const std::string& what) { planet.complain(key, *planet.find(key), what); };
  if (curves) {
    complain(
        "is lit in three channels alone, and this preset has curves over the wavelength; give media, ground and sun by "
        "three channels, or remove it");
  }
  if (const std::string names = who_knows(scene, &MethodInfo::knows_ground_maps, methods); !names.empty()) {
    complain("the method " + json_string(scene.render.method) + " knows one albedo alone; choose " + names +
             " with render.method or --method, or remove it");
  }
  if (scene.terrain || !scene.spheres.empty()) {
    complain(std::string("there ") + (scene.terrain ? "is planet.terrain" : "are scene.spheres") +
             " beside it, and neither would see the other; remove one of the two");
  }
}

}  // namespace

void refuse_misfits(const Section& root, const Scene& scene, bool curves, std::span<const MethodInfo> methods) {
  if (scene.terrain) {
    refuse_terrain_beside(root, scene, methods);
  }
  if (scene.ground) {
    refuse_ground_map_beside(root, scene, curves, methods);
  }
  if (!scene.spheres.empty()) {
    refuse_spheres_beside(root, scene, methods);
  }
}

}  // namespace airlight
