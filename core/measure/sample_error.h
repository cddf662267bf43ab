#pragma once
// The error of radiance at listed directions or pixels that stand for a picture: the relative error of metrics.h with
// its channels pooled, weighted where the sample is denser in one part than in another.

#include <cstddef>
#include <span>
#include <vector>

namespace airlight::measure {

// Errors are cut off here: NaN, infinity, light where the reference is black.
inline constexpr double kWorstError = 1e6;

struct SampleError {
  double mean = 0.0;     // weighted, over the samples and the three channels
  double p95 = 0.0;      // weighted nearest rank
  double spread = 0.0;   // standard error of `mean` as an estimate of the picture's, 0 with fewer than two samples
  std::size_t used = 0;  // samples; those that are black in both, such as empty space, are not
};

// `a`, `reference`: RGB, three values a sample, of equal length. `weights`: one a sample, or empty: all alike. `dark`:
// an error is at most relative to that radiance, however dark the picture.
SampleError sample_error(std::span<const float> a, std::span<const float> reference,
                         std::span<const double> weights = {}, double dark = 0.0);

// Weighted mean of sigma / max(reference, floor) over the same samples: how well the reference itself is known.
double sample_noise(std::span<const float> reference, std::span<const float> sigma,
                    std::span<const double> weights = {});

// What a noisy reference tells of an error: the mean of distance / reference over the same samples is `noise`, which a
// normal distribution of `sigma` alone would make it, and `excess`, by which it is more than that.
struct NoisyError {
  double noise = 0.0;
  double excess = 0.0;  // below 0 by chance
  double spread = 0.0;  // standard error of `excess`, 0 with fewer than two samples
  std::size_t used = 0;
};
NoisyError noisy_error(std::span<const float> a, std::span<const float> reference, std::span<const float> sigma,
                       std::span<const double> weights = {});
inline constexpr double kMeanOfNormal = 0.7978845608028654;  // mean magnitude over standard deviation

}  // namespace airlight::measure
