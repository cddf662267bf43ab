#pragma once
// Whether air asks to be gone through by shells (shaders/physics/shells.glsl), and at which altitudes it is cut.

#include <vector>

#include "core/air/column.h"
#include "core/scene/scene.h"

namespace airlight {

// Rows of the table of moments in hazy air, for `moment_rows` in clear air.
int hazy_rows(int moment_rows);

// Where a medium that scatters ends abruptly or in a kink; where the vertical optical depth of scattering is above 1.2
// in some channel; or where it is above 0.4 and more than 0.4 of it stands between two of the table's hazy_rows(),
// which are at table_top (k / (rows - 1))^2 km.
bool needs_shells(const Column& column, const std::vector<Medium>& media, double table_top, int moment_rows);

// Edges of the shells from 0 to the top of the atmosphere, rising, two to five times as many as the table of moments
// has rows, and at most kMaxShellRows: every break of the column, and between them close where the optical depth grows
// fast, closest next to the ends of the air, where the light field bends most.
std::vector<double> shell_altitudes(const Column& column, int moment_rows);

}  // namespace airlight
