// What the statistics passes leave for each row of a picture or a table; scalar layout, the same text in C++.
struct RowStatistics {
  real weight;             // of what is metered: sum of the root of each texel's luminance
  real log_luminance_sum;  // natural logarithm, so weighted
  real max_luminance;
  uint not_finite;  // texels with a NaN or an infinity
  uint negative;    // texels with a negative channel, of signed colours (kSigned) with a negative luminance
  uint outside;     // of signed colours: texels with a negative channel, whose colour no screen of theirs has
  uint first_bad;   // column of the first that is not finite or negative; the row's length where there is none
};
