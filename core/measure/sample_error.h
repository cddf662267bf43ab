#pragma once
// The error of radiance at listed directions or pixels that represent a picture. It is the relative error of metrics.h
// with the channels pooled, weighted where samples are denser in one part than in another.

#include <cstddef>
#include <span>
#include <vector>

namespace airlight::measure {

// Errors are limited to this value: NaN, infinity, light where the reference is black.
inline constexpr double kWorstError = 1e6;

struct SampleError {
  double mean = 0.0;     // weighted, over the samples and the three channels
  double p95 = 0.0;      // weighted nearest rank
  double spread = 0.0;   // standard error of `mean` as an estimate of the picture's, 0 with fewer than two samples
  std::size_t used = 0;  // number of samples; those black in both, such as empty space, are left out
};

// `a`, `reference`: RGB, three values a sample, of equal length. `weights`: one a sample; empty: all equal. `dark`: the
// least radiance that an error is relative to, however dark the picture.
SampleError sample_error(std::span<const float> a, std::span<const float> reference,
                         std::span<const double> weights = {}, double dark = 0.0);

// Weighted mean of sigma / max(reference, floor) over the same samples: the reference's own uncertainty.
double sample_noise(std::span<const float> reference, std::span<const float> sigma,
                    std::span<const double> weights = {});

// An error measured against a noisy reference. `noise`: mean of distance / reference over the same samples if the only
// cause were a normal distribution of `sigma`. `excess`: the measured mean less `noise`.
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
