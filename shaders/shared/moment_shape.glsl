// Shape of the table of moments: blocks of kMomentColumns side by side.
layout(constant_id = 11) const uint kMomentDegree = 2u;
layout(constant_id = 12) const uint kDeltaScaled = 0u;
layout(constant_id = 13) const uint kMomentColumns = 48u;
layout(constant_id = 14) const uint kMomentRows = 12u;
layout(constant_id = 34) const uint kMomentPolarised = 0u;
layout(constant_id = 32) const uint kMomentScattered = 8u;

uint moment_degree() { return kMomentDegree; }
#ifdef AIRLIGHT_DEGREE_PUSHED
uint source_degree();
#else
uint source_degree() { return kMomentDegree; }
#endif
// 0 is a constant wherever molecules alone scatter, so that no code is left of what the moments would add.
uint scattered_degree() { return kMomentScattered == 0u ? 0u : min(kMomentScattered, source_degree()); }
bool polarised() { return kMomentPolarised != 0u; }
bool delta_scaled() { return kDeltaScaled != 0u; }

#include "shared/shell_rows.glsl"
#include "physics/moment_places.glsl"
