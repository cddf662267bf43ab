// Sizes of the night sky's buffers, for the host as well.
const uint kNightSide = 129u;   // of the octahedral map of the light above the air, whose outer texels lie on its edge
const uint kNightSlopes = 32u;  // of the light that the air scatters: zenith cosines on either side of the horizon
