#pragma once
// The numbers that a walk draws.

#include <cstdint>

#include "core/methods/path_trace/random.h"

namespace airlight {

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

}  // namespace airlight
