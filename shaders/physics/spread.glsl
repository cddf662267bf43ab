// Thresholds spread evenly over every small patch of pixels, nearly blue noise: the additive recurrence of the plastic
// number (the "R2" sequence of Martin Roberts, 2018). The steps are 1/p and 1/p^2, p^3 = p + 1, as 32-bit fractions.

const uint kSpreadX = 3242174889u;
const uint kSpreadY = 2447445414u;

// The threshold of the pixel in column x, row y, as a 32-bit fraction.
uint spread_bits(uint x, uint y) { return x * kSpreadX + y * kSpreadY; }

// The threshold of that pixel between 0 and 1, both excluded.
real spread_place(uint x, uint y) { return (real(spread_bits(x, y) >> 8u) + 0.5) / 16777216.0; }
