// Shape of the picture's table of factors: columns over azimuth, rows of three sections, blocks side by side: one for
// each medium that scatters, then the diffuse light.
#include "shared/scattering_media.glsl"

layout(constant_id = 16) const uint kSkyColumns = 48u;
layout(constant_id = 17) const uint kGroundRows = 32u;
layout(constant_id = 18) const uint kLimbRows = 48u;
layout(constant_id = 19) const uint kSkyRows = 64u;

uint section_first(uint section) { return section == 0u ? 0u : section == 1u ? kGroundRows : kGroundRows + kLimbRows; }
uint section_rows(uint section) { return section == 0u ? kGroundRows : section == 1u ? kLimbRows : kSkyRows; }
