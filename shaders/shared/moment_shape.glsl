// Shape of the table of moments: blocks of kMomentColumns side by side, one a moment, the last the irradiance.
layout(constant_id = 11) const uint kMomentDegree = 2u;
layout(constant_id = 12) const uint kDeltaScaled = 0u;
layout(constant_id = 13) const uint kMomentColumns = 48u;
layout(constant_id = 14) const uint kMomentRows = 12u;

uint moment_degree() { return kMomentDegree; }
bool delta_scaled() { return kDeltaScaled != 0u; }
