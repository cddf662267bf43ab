// Statistics of a row, texel by texel: counts of bad values, and the sums for the exposure's meter. A texel weighs as
// the root of its luminance: black weighs nothing, ground 600 times darker than the sky next to nothing. In a picture k
// times as bright the mean is k times as bright.
// The includer declares before it: RowStatistics, luminance_bt709(), bool is_finite(real).

RowStatistics empty_statistics(uint width) {
  RowStatistics s;
  s.weight = 0.0;
  s.log_luminance_sum = 0.0;
  s.max_luminance = 0.0;
  s.not_finite = 0u;
  s.negative = 0u;
  s.outside = 0u;
  s.first_bad = width;
  return s;
}

// Adds the texel at column x. Alpha 0 leaves it out of the meter; a luminance above `brightest` counts as `brightest`;
// signed colours may have negative channels, but no negative luminance.
RowStatistics with_texel(RowStatistics s, vec3 value, real alpha, uint x, real brightest, bool signed_colours) {
  bool finite = is_finite(value.x) && is_finite(value.y) && is_finite(value.z);
  bool below = finite && (value.x < 0.0 || value.y < 0.0 || value.z < 0.0);
  real luminance = finite ? luminance_bt709(value) : 0.0;
  real metered = clamp(luminance, 1e-37, brightest);
  real weight = luminance > 0.0 && alpha > 0.0 ? sqrt(metered) : 0.0;
  bool negative = signed_colours ? luminance < 0.0 : below;
  s.weight += weight;
  s.log_luminance_sum += weight * log(metered);
  s.max_luminance = max(s.max_luminance, luminance);
  s.not_finite += finite ? 0u : 1u;
  s.negative += negative ? 1u : 0u;
  s.outside += below && signed_colours ? 1u : 0u;
  s.first_bad = !finite || negative ? min(s.first_bad, x) : s.first_bad;
  return s;
}

// Sum of two rows' statistics, or of two parts of a row.
RowStatistics sum_of(RowStatistics a, RowStatistics b) {
  a.weight += b.weight;
  a.log_luminance_sum += b.log_luminance_sum;
  a.max_luminance = max(a.max_luminance, b.max_luminance);
  a.not_finite += b.not_finite;
  a.negative += b.negative;
  a.outside += b.outside;
  a.first_bad = min(a.first_bad, b.first_bad);
  return a;
}
