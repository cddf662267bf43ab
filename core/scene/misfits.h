#pragma once
// What the things of a scene do not go with: methods that do not know them, one another, curves over the wavelength.

#include <span>

#include "core/scene/method_info.h"
#include "core/scene/section.h"

namespace airlight {

// Reports each misfit of terrain, a ground by maps and spheres. `curves`: the preset has some over the wavelength.
void refuse_misfits(const Section& root, const Scene& scene, bool curves, std::span<const MethodInfo> methods);

}  // namespace airlight
