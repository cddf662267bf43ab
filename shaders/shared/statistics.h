// What the statistics passes leave for each row of a picture or a table; scalar layout, the same text in C++.
struct RowStatistics {
  real weight;             // of what is metered: sum of the root of each texel's luminance
  real log_luminance_sum;  // natural logarithm, so weighted
  real max_luminance;
  uint not_finite;  // texels with a NaN or an infinity
  uint negative;    // texels with a negative channel, the rest finite
  uint first_bad;   // column of the first of either; the row's length where there is none
};
