// Sizes of the night sky's buffers, for the host as well.
const uint kNightColumns = 180u;  // of the map of the light above the air: azimuths clockwise from north
const uint kNightRows = 90u;      // elevations from the zenith down
const uint kNightSlopes = 32u;    // of the light that the air scatters: zenith cosines on either side of the horizon
