// Shape of the table of moments: blocks of kMomentColumns side by side.
layout(constant_id = 11) const uint kMomentDegree = 2u;
layout(constant_id = 12) const uint kDeltaScaled = 0u;
layout(constant_id = 13) const uint kMomentColumns = 48u;
layout(constant_id = 14) const uint kMomentRows = 12u;
layout(constant_id = 22) const uint kSourceDegree = 8u;  // of what an order takes from the one before, and keeps
layout(constant_id = 34) const uint kMomentPolarised = 0u;
layout(constant_id = 32) const uint kMomentScattered = 8u;

uint moment_degree() { return kMomentDegree; }
uint source_degree() { return min(kSourceDegree, kMomentDegree); }
uint scattered_degree() { return min(kMomentScattered, source_degree()); }
bool polarised() { return kMomentPolarised != 0u; }
bool delta_scaled() { return kDeltaScaled != 0u; }

#include "shared/shell_rows.glsl"
#include "physics/moment_places.glsl"
