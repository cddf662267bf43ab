// What the statistics passes leave for each row of a picture or a table; scalar layout, the same text in C++.
struct RowStatistics {
  real log_luminance_sum;  // natural logarithm, over lit texels
  real lit;                // texels with finite, positive luminance
  real max_luminance;
  uint not_finite;         // texels with a NaN or an infinity
  uint negative;           // texels with a negative channel, the rest finite
  uint first_bad;          // column of the first of either; the row's length where there is none
};
