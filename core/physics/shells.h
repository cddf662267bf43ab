#pragma once
// Whether a scene's air is gone through by shells (shaders/physics/shells.glsl), and at which altitudes it is cut.

#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// render.shells, or, where it says `auto`, what the air asks for: shells where a medium that scatters ends abruptly or
// in a kink, or the vertical optical depth of scattering is above 0.4 in some channel. False for methods without the
// parameter. `p`: formulas and media of the scene.
bool uses_shells(const Scene& scene, physics::Physics& p);

// Edges of the shells from 0 to the top of the atmosphere, rising, two to three times as many as render.moments_lut has
// rows, and at most kMaxShellRows: every altitude where a density jumps or bends, and between them close where the
// optical depth grows fast, closest next to the ends of the air, where the light field bends most.
std::vector<double> shell_altitudes(const Scene& scene, physics::Physics& p);

}  // namespace airlight
