#pragma once
// What may stand in a scene's air, on its ground or before its camera beside the planet itself, one row each.

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/member.h"
#include "core/scene/method_info.h"
#include "core/scene/scene.h"

namespace airlight {

struct ThingKind {
  std::string_view name;                 // for messages, in the plural
  std::string_view section;              // of the preset; empty: the preset itself
  std::array<std::string_view, 2> keys;  // in it, one of which puts the thing there
  MemberOf<MethodInfo, bool> known;
  bool (*stands_in)(const Scene&);
  bool at_true_distance = false;  // where the air bends light, its lengths are true ones near the camera
};

inline constexpr std::array<ThingKind, 5> kThingKinds{
    {{"terrain",
      "planet",
      {"terrain", ""},
      &MethodInfo::knows_terrain,
      [](const Scene& s) { return !!s.terrain; },
      true},
     {"spheres",
      "scene",
      {"spheres", ""},
      &MethodInfo::knows_bodies,
      [](const Scene& s) { return !s.spheres.empty(); },
      true},
     {"clouds", "", {"clouds", ""}, &MethodInfo::knows_clouds, [](const Scene& s) { return !s.clouds.empty(); }, true},
     {"maps of the ground",
      "planet",
      {"albedo_map", "ocean"},
      &MethodInfo::knows_ground_maps,
      [](const Scene& s) { return !!s.ground; },
      true},
     {"polarising filters", "camera", {"polariser", ""}, &MethodInfo::knows_polarisers, [](const Scene& s) {
        return !!s.camera.polariser;
      }}}};

// Whether the method supports all things of the scene.
inline bool knows_things_of(const MethodInfo& method, const Scene& scene) {
  return std::ranges::all_of(kThingKinds,
                             [&](const ThingKind& kind) { return !kind.stands_in(scene) || method.*kind.known; });
}

// Whether bodies stand in the air (shaders/physics/bodies.glsl).
inline bool has_bodies(const Scene& scene) {
  return std::ranges::any_of(kThingKinds, [&](const ThingKind& kind) {
    return kind.known == &MethodInfo::knows_bodies && kind.stands_in(scene);
  });
}

inline bool stand_at_true_distance(const Scene& scene) {
  return std::ranges::any_of(kThingKinds, [&](const ThingKind& k) { return k.at_true_distance && k.stands_in(scene); });
}

}  // namespace airlight
