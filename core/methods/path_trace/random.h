#pragma once
// Random numbers as a function of their purpose: the same whatever the order or the number of threads.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace airlight {

// A bijection of 64-bit words that leaves no visible structure (the finaliser of SplitMix64, Steele et al. 2014).
inline std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

inline constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;

// The stream of one purpose: number k is a hash of (key, k).
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
      : state_(mix_bits(mix_bits(mix_bits(seed + kGoldenGamma) + pixel + kGoldenGamma) + sample + kGoldenGamma)) {}

  // A multiple of 2^-53 in [0, 1).
  double uniform() {
    state_ += kGoldenGamma;
    return static_cast<double>(mix_bits(state_) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

inline constexpr int kBatch = 16;  // samples that share one even spread

// The first numbers of a walk, spread evenly over a batch of samples; the rest come from the sample's own stream.
class WalkNumbers {
 public:
  WalkNumbers(std::uint64_t seed, std::uint64_t pixel, std::uint64_t batch, int index);
  double next();
  Random& random() { return random_; }

 private:
  Random shifts_;  // the batch's, equal for each of its samples
  Random random_;
  int index_;
  int dimension_ = 0;
};

// Draws an entry of a list of weights. `left`: a number in [0, sum of the weights). Afterwards it is the place within
// the drawn entry, in [0, 1), which may serve as the next random number.
template <class Weight>
std::size_t draw(std::size_t count, Weight weight, double& left) {
  std::size_t last = 0;
  double last_weight = 1.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double w = weight(k);
    if (w > 0.0) {
      last = k;
      last_weight = w;
      if (left < w) {
        break;
      }
      left -= w;
    }
  }
  left = std::clamp(left / last_weight, 0.0, 1.0 - 0x1p-52);
  return last;
}

}  // namespace airlight
