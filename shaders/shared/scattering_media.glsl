// Blocks of a table, or layers of a picture: one for each medium that scatters, then the rest.
#ifndef AIRLIGHT_SCATTERING_MEDIA
#define AIRLIGHT_SCATTERING_MEDIA

layout(constant_id = 20) const uint kScatteringMedia = 3u;  // bit i: medium i scatters

bool scatters(uint i) { return i < kMediumCount && ((kScatteringMedia >> i) & 1u) != 0u; }
uint single_block(uint i) { return bitCount(kScatteringMedia & ((1u << i) - 1u)); }
uint diffuse_block() { return bitCount(kScatteringMedia); }

#endif
