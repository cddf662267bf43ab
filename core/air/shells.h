#pragma once
// Whether air asks to be gone through by shells (shaders/physics/shells.glsl), and at which altitudes it is cut.

#include <vector>

#include "core/air/column.h"
#include "core/scene/scene.h"

namespace airlight {

// Where a medium that scatters ends abruptly or in a kink, or the vertical optical depth of scattering is above 0.4 in
// some channel.
bool needs_shells(const Column& column, const std::vector<Medium>& media);

// Edges of the shells from 0 to the top of the atmosphere, rising, two to five times as many as the table of moments
// has rows, and at most kMaxShellRows: every break of the column, and between them close where the optical depth grows
// fast, closest next to the ends of the air, where the light field bends most.
std::vector<double> shell_altitudes(const Column& column, int moment_rows);

}  // namespace airlight
