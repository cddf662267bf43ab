#include <algorithm>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/readers.h"
#include "core/scene/resolve.h"
#include "core/scene/thing_kinds.h"

namespace airlight {
namespace {

// The value that the pointer leads to, or the last on the way there.
const PresetValue& nearest_value(const PresetValue& root, std::string_view pointer) {
  const PresetValue* found = find_value(root, pointer);
  return found != nullptr ? *found : nearest_value(root, pointer.substr(0, pointer.rfind('/')));
}

void add_misfits_of_method(const PresetValue& root, const Scene& scene, std::span<const MethodInfo> methods,
                           Problems& problems) {
  const auto method = std::ranges::find(methods, scene.render.method, &MethodInfo::name);
  if (method != methods.end() && method->misfits != nullptr && !problems.any()) {
    for (const Misfit& misfit : method->misfits(scene)) {
      problems.add(nearest_value(root, misfit.pointer), misfit.pointer, misfit.message);
    }
  }
}

}  // namespace

void refuse_misfits(const Preset& preset, const Scene& scene, std::span<const MethodInfo> methods) {
  Problems problems;
  add_misfits_of_method(preset.root, scene, methods, problems);
  problems.throw_if_any();
}

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
  add_misfits_of_method(root.context(), scene, methods, root.problems());
}

}  // namespace airlight
