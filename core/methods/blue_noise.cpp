#include "core/methods/blue_noise.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <random>

namespace airlight {
namespace {

// Points on a torus, and how crowded each place is: a Gaussian around every point, in whole numbers, so that no order
// of sums and no library's rounding changes a rank.
class Crowd {
 public:
  explicit Crowd(std::size_t side) : side_(side), taken_(side * side), crowding_(side * side) {
    constexpr double kSigma = 1.5;  // pixels [U93]
    for (int y = -kReach; y <= kReach; ++y) {
      for (int x = -kReach; x <= kReach; ++x) {
        kernel_.push_back(std::llround(0x1p32 * std::exp(-(x * x + y * y) / (2.0 * kSigma * kSigma))));
      }
    }
  }

  bool taken(std::size_t place) const { return taken_[place]; }

  void put(std::size_t place) { change(place, true); }
  void take(std::size_t place) { change(place, false); }

  // Of the points the most crowded, of the free places the least; the first of equals.
  std::size_t tightest_cluster() const { return extreme(true); }
  std::size_t largest_void() const { return extreme(false); }

 private:
  static constexpr int kReach = 6;  // four sigma: 3e-4 of the middle

  void change(std::size_t place, bool put) {
    taken_[place] = put;
    const std::size_t mask = side_ - 1;
    std::size_t k = 0;
    for (int y = -kReach; y <= kReach; ++y) {
      const std::size_t row = (place / side_ + static_cast<std::size_t>(y + kReach) + side_ - kReach) & mask;
      for (int x = -kReach; x <= kReach; ++x) {
        const std::size_t column = (place % side_ + static_cast<std::size_t>(x + kReach) + side_ - kReach) & mask;
        crowding_[row * side_ + column] += put ? kernel_[k] : -kernel_[k];
        ++k;
      }
    }
  }

  std::size_t extreme(bool taken) const {
    std::size_t best = taken_.size();
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i] == taken &&
          (best == taken_.size() || (taken ? crowding_[i] > crowding_[best] : crowding_[i] < crowding_[best]))) {
        best = i;
      }
    }
    return best;
  }

  std::size_t side_;
  std::vector<bool> taken_;
  std::vector<std::int64_t> crowding_;
  std::vector<std::int64_t> kernel_;
};

// A tenth of the places, moved from clusters to voids until none moves.
Crowd first_points(std::size_t side, std::size_t& count) {
  Crowd crowd(side);
  std::mt19937 random(1);
  count = side * side / 10;
  for (std::size_t n = 0; n < count;) {
    const std::size_t place = random() % (side * side);
    if (!crowd.taken(place)) {
      crowd.put(place);
      ++n;
    }
  }
  for (;;) {
    const std::size_t cluster = crowd.tightest_cluster();
    crowd.take(cluster);
    const std::size_t hole = crowd.largest_void();
    crowd.put(hole);
    if (hole == cluster) {
      return crowd;
    }
  }
}

}  // namespace

// The first points are ranked by taking the tightest cluster away, the rest by filling the largest void: as the sum
// over all places is the same everywhere, the largest void is also the tightest cluster of free places.
std::vector<float> void_and_cluster(std::size_t side) {
  assert(side >= 16 && side <= 128 && (side & (side - 1)) == 0);
  std::size_t count = 0;
  Crowd crowd = first_points(side, count);
  const std::size_t places = side * side;
  std::vector<float> mask(places);
  const auto rank = [&](std::size_t place, std::size_t r) {
    mask[place] = (static_cast<float>(r) + 0.5f) / static_cast<float>(places);
  };
  Crowd sparse = crowd;
  for (std::size_t r = count; r-- > 0;) {
    const std::size_t place = sparse.tightest_cluster();
    sparse.take(place);
    rank(place, r);
  }
  for (std::size_t r = count; r < places; ++r) {
    const std::size_t place = crowd.largest_void();
    crowd.put(place);
    rank(place, r);
  }
  return mask;
}

}  // namespace airlight
