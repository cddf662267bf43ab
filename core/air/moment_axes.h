#pragma once
// What the table of radiance moments needs to know about the air, on double.

#include "core/air/column.h"
#include "core/physics/physics.h"

namespace airlight {

// Axes of the moment table: the altitude under which all but 1.5e-4 of the vertical scattering optical depth lies, and
// sun elevations from nadir to zenith, densest around the horizon.
physics::MomentTableData moment_axes(physics::Physics& p, const Column& column);

// The same where the table's rows are edges of shells: up to the top of the atmosphere, and down to a sun so low that
// light scattered twice no longer matters, as a flat planet's night needs no columns.
physics::MomentTableData shell_moment_axes(physics::Physics& p);

}  // namespace airlight
