#pragma once
// How far a picture A is from a reference B: pure functions on one channel's values, or on several channels laid end to
// end. Nothing here reads files.
//
// Relative error: |a - b| / max(|b|, kRelativeFloor x mean|b|), the mean taken over the whole picture of that channel,
// so that a black corner does not turn rounding into a large figure.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace airlight::measure {

inline constexpr double kRelativeFloor = 1e-3;  // of mean|b|

// NaN and infinities: unequal to everything, or equal to their own kind (NaN to NaN, +inf to +inf). A finite value
// never equals a non-finite one.
enum class NonfiniteRule { never_equal, equal_to_same };

// Bits that tell the region of a pixel. The caller defines their meaning (view_geometry.h has the sky's).
using RegionBits = std::uint8_t;

// The pixels of a figure: all, or those with any of `wanted` set. `bits` holds one value a pixel; channels laid end to
// end share it.
struct Area {
  std::span<const RegionBits> bits = {};
  RegionBits wanted = 0;
};

// Percentiles by nearest rank. A value that cannot be compared has an infinite error, the largest of all.
struct ErrorSummary {
  std::size_t count = 0;     // values in the area; 0 leaves the figures NaN
  std::size_t infinite = 0;  // errors without a figure: NaN or infinity, or a black reference
  double mean = std::numeric_limits<double>::quiet_NaN();
  double p50 = std::numeric_limits<double>::quiet_NaN();
  double p95 = std::numeric_limits<double>::quiet_NaN();
  double p99 = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  std::size_t worst = 0;  // index of the first largest error
};

// Sums for RMS, PSNR and bias; those of several channels add.
struct Deviation {
  std::size_t count = 0;
  double sum_squares = 0.0;
  double sum_a = 0.0;
  double sum_b = 0.0;
  double peak = 0.0;  // largest |b|

  Deviation& operator+=(const Deviation& other);
  double rms() const;
  double psnr() const;  // dB below B's largest magnitude; infinite when equal
  double bias() const;  // (mean a - mean b) / |mean b|, from which random noise averages out
};

// Squared distances in units of the standard error: near 1 per value when only noise separates the two.
struct ChiSquare {
  std::size_t count = 0;  // values with a standard error above 0
  double sum = 0.0;
  std::size_t unequal_exact = 0;  // standard error 0, yet different

  ChiSquare& operator+=(const ChiSquare& other);
  double per_value() const;
};

// Mean of |value| over the finite values; 0 when there is none.
double mean_magnitude(std::span<const float> values);

std::vector<float> absolute_errors(std::span<const float> a, std::span<const float> b,
                                   NonfiniteRule rule = NonfiniteRule::never_equal);

// The floor comes from `reference_mean`, or from mean_magnitude(b).
std::vector<float> relative_errors(std::span<const float> a, std::span<const float> b, double reference_mean,
                                   NonfiniteRule rule = NonfiniteRule::never_equal);
std::vector<float> relative_errors(std::span<const float> a, std::span<const float> b);

// |a - b| / sigma; where sigma is 0: 0 if equal, else infinite.
std::vector<float> sigma_errors(std::span<const float> a, std::span<const float> b, std::span<const float> sigma,
                                NonfiniteRule rule = NonfiniteRule::never_equal);

ErrorSummary summarize(std::span<const float> errors, const Area& area = {});

// The same of several channels, laid end to end. `scratch` is for the chosen errors; one for many calls saves the time
// that new memory takes.
ErrorSummary summarize(std::span<const std::span<const float>> channels, const Area& area, std::vector<float>& scratch);

// Errors above the threshold; an infinite error is above every threshold.
std::size_t count_over(std::span<const float> errors, double threshold, const Area& area = {});

Deviation deviation(std::span<const float> a, std::span<const float> b, const Area& area = {},
                    NonfiniteRule rule = NonfiniteRule::never_equal);

ChiSquare chi_square(std::span<const float> a, std::span<const float> b, std::span<const float> sigma,
                     const Area& area = {}, NonfiniteRule rule = NonfiniteRule::never_equal);

}  // namespace airlight::measure
