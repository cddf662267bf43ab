// Output of the statistics passes for each row of a picture or a table; scalar layout, the same text in C++.
struct RowStatistics {
  real weight;             // of metered texels: sum of the root of their luminance
  real log_luminance_sum;  // natural logarithms, weighted likewise
  real max_luminance;
  uint not_finite;  // texels with a NaN or an infinity
  uint negative;    // texels with a negative channel; for signed colours (kSigned) with a negative luminance
  uint outside;     // for signed colours: texels with a negative channel, whose colour lies outside BT.709
  uint first_bad;   // column of the first texel that is not finite or negative; else the row's length
};
