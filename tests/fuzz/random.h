#pragma once
// Random numbers by a seed, the same on every machine: the standard fixes its engines, but not its distributions.

#include <cmath>
#include <cstdint>
#include <random>
#include <span>

namespace airlight::fuzz {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed * 0x9e3779b97f4a7c15U + 1U) {}

  std::uint64_t below(std::uint64_t count) { return engine_() % count; }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  template <class Range>
  decltype(auto) pick(const Range& range) {
    return range[below(std::size(range))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace airlight::fuzz
