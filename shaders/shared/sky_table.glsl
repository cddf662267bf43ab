// Shape of the picture's table of factors: columns over azimuth, rows of three sections, blocks side by side. Each
// medium whose phase function is left to the pixel has a block; the last block holds the diffuse light and the folded
// media. The table of layers also has a block for each folded medium.
#include "shared/scattering_media.glsl"

layout(constant_id = 16) const uint kSkyColumns = 48u;
layout(constant_id = 17) const uint kGroundRows = 32u;
layout(constant_id = 18) const uint kLimbRows = 48u;
layout(constant_id = 19) const uint kSkyRows = 64u;

// A table without rows above level is that of a camera above the air (physics/space_table.glsl).
bool table_from_space() { return kSkyRows == 0u; }

layout(constant_id = 25) const uint kFoldedMedia = 0u;      // bit i: medium i is in the shared block, phased
layout(constant_id = 26) const uint kRayleighCarrier = 0u;  // 1: the shared block has a carrier

bool folded(uint i) { return i < kMediumCount && ((kFoldedMedia >> i) & 1u) != 0u; }

// The table holds the shared block divided by this carrier, and the pixel multiplies by it. Rayleigh's phase function,
// most of a clear sky, is thereby exact however coarse the table. The ground section has carrier 1: its light is even.
float shared_carrier(uint section, float nu) {
  return kRayleighCarrier != 0u && section != 0u ? 1.0 + nu * nu : 1.0;
}

uint section_first(uint section) { return section == 0u ? 0u : section == 1u ? kGroundRows : kGroundRows + kLimbRows; }
uint section_rows(uint section) { return section == 0u ? kGroundRows : section == 1u ? kLimbRows : kSkyRows; }
