// The columns of the table of moments, one per sun elevation, at which an order is gathered: `count` columns, spread
// evenly, both ends included.

uint gathered_column(uint count, uint i) { return (i * (kMomentColumns - 1u) + (count - 1u) / 2u) / (count - 1u); }

struct GatheredColumns {
  uint low;
  uint high;
  float part;  // 0 at low, 1 at high
};

// The two gathered columns on either side of a column.
GatheredColumns gathered_around(uint count, uint column) {
  uint i = min(column * (count - 1u) / (kMomentColumns - 1u), count - 2u);
  i = i > 0u && gathered_column(count, i) > column ? i - 1u : i;
  i = i + 2u < count && gathered_column(count, i + 1u) <= column ? i + 1u : i;
  GatheredColumns around;
  around.low = gathered_column(count, i);
  around.high = gathered_column(count, i + 1u);
  around.part = float(column - around.low) / float(around.high - around.low);
  return around;
}
