#include "core/methods/path_trace/random.h"

#include <array>
#include <cmath>

namespace airlight {
namespace {

constexpr int kEvenDimensions = 9;  // three a vertex

}  // namespace

WalkNumbers::WalkNumbers(std::uint64_t seed, std::uint64_t pixel, std::uint64_t batch, int index)
    : shifts_(~seed, pixel, batch),
      random_(seed, pixel, batch * kBatch + static_cast<std::uint64_t>(index)),
      index_(index) {}

// Kronecker's sequence on powers of the root of x^10 = x + 1, shifted at random as a whole for each batch.
double WalkNumbers::next() {
  if (dimension_ >= kEvenDimensions) {
    return random_.uniform();
  }
  static const std::array<double, kEvenDimensions> steps = [] {
    double root = 1.0;
    for (int k = 0; k < 60; ++k) {
      root = std::pow(1.0 + root, 1.0 / (kEvenDimensions + 1));
    }
    std::array<double, kEvenDimensions> list;
    for (std::size_t d = 0; d < list.size(); ++d) {
      list[d] = std::pow(root, -static_cast<double>(d + 1));
    }
    return list;
  }();
  const double x = shifts_.uniform() + index_ * steps[static_cast<std::size_t>(dimension_)];
  ++dimension_;
  return x - std::floor(x);
}

}  // namespace airlight
