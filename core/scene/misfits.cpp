#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/readers.h"
#include "core/scene/thing_kinds.h"

namespace airlight {

void refuse_misfits(const Section& root, const Scene& scene, std::span<const MethodInfo> methods) {
  for (const ThingKind& kind : kThingKinds) {
    const auto knows = [&](const MethodInfo& method) { return method.*kind.known; };
    const auto is_known = [&](const MethodInfo& method) { return method.name == scene.render.method && knows(method); };
    const std::string names =
        joined_of(methods, [&](const MethodInfo& other) { return knows(other) ? other.name : std::string_view(); });
    if (!kind.stands_in(scene) || names.empty() || std::ranges::any_of(methods, is_known)) {
      continue;
    }
    const Section section = kind.section.empty() ? root : root.child(kind.section);
    const std::string_view key = section.find(kind.keys[0]) != nullptr ? kind.keys[0] : kind.keys[1];
    section.complain(key, *section.find(key),
                     "the method " + json_string(scene.render.method) + " knows no " + std::string(kind.name) +
                         "; choose " + names + " with render.method or --method, or remove it");
  }
  if (scene.camera.polariser && !scene.render.polarisation) {
    const Section camera = root.child("camera");
    camera.complain("polariser", *camera.find("polariser"),
                    "render.polarisation is false, and light without polarisation passes all filters alike; set it to "
                    "true, or remove the filter");
  }
}

}  // namespace airlight
