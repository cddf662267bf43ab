#pragma once
// Preset -> Scene: every rule of the format in one place.

#include <span>
#include <string>

#include "core/scene/method_info.h"
#include "core/scene/preset.h"
#include "core/scene/scene.h"

namespace airlight {

// Throws InputError with every problem found, one line each:
//   FILE: POINTER: what is wrong; what was expected; what to do
Scene resolve(const Preset& preset, std::span<const MethodInfo> methods);

// Throws InputError likewise for what keeps the scene's method from rendering it. resolve() does so too; again where
// heights of clouds have come from files that it does not read.
void refuse_misfits(const Preset& preset, const Scene& scene, std::span<const MethodInfo> methods);

// The scene for people: every value with its unit, for `check -v` and `--dry-run`.
std::string describe(const Scene& scene);

}  // namespace airlight
