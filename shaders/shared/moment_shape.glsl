// Shape of the table of moments: blocks of kMomentColumns side by side.
layout(constant_id = 11) const uint kMomentDegree = 2u;
layout(constant_id = 12) const uint kDeltaScaled = 0u;
layout(constant_id = 13) const uint kMomentColumns = 48u;
layout(constant_id = 14) const uint kMomentRows = 12u;

layout(constant_id = 21) const uint kShellRows = 0u;  // 0: altitudes go with a square root, not by shells
layout(constant_id = 22) const uint kSourceDegree = 8u;  // of what an order takes from the one before, and keeps

uint moment_degree() { return kMomentDegree; }
uint source_degree() { return min(kSourceDegree, kMomentDegree); }
bool delta_scaled() { return kDeltaScaled != 0u; }
uint shell_rows() { return kShellRows; }

#include "physics/moment_places.glsl"
