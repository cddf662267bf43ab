// Shape of the picture's table of factors: columns over azimuth, rows of three sections, blocks side by side: one for
// each medium whose phase function is left to the pixel, then one that the diffuse light shares with the folded media.
// The table of layers has a block for the folded ones as well.
#include "shared/scattering_media.glsl"

layout(constant_id = 16) const uint kSkyColumns = 48u;
layout(constant_id = 17) const uint kGroundRows = 32u;
layout(constant_id = 18) const uint kLimbRows = 48u;
layout(constant_id = 19) const uint kSkyRows = 64u;

// No row above level: the camera is above the air (physics/space_table.glsl).
bool table_from_space() { return kSkyRows == 0u; }

layout(constant_id = 25) const uint kFoldedMedia = 0u;      // bit i: medium i is in the shared block, phase and all
layout(constant_id = 26) const uint kRayleighCarrier = 0u;  // of the shared block

bool folded(uint i) { return i < kMediumCount && ((kFoldedMedia >> i) & 1u) != 0u; }

// What the shared block is divided by in the table and multiplied by at the pixel, so that Rayleigh's phase function,
// most of a clear sky, is exact however coarse the table. Not where the ground, alike from all sides, shines through.
float shared_carrier(uint section, float nu) {
  return kRayleighCarrier != 0u && section != 0u ? 1.0 + nu * nu : 1.0;
}

uint section_first(uint section) { return section == 0u ? 0u : section == 1u ? kGroundRows : kGroundRows + kLimbRows; }
uint section_rows(uint section) { return section == 0u ? kGroundRows : section == 1u ? kLimbRows : kSkyRows; }
