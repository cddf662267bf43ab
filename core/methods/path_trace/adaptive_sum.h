#pragma once
// An integral along a ray. Panels are halved until both halves together agree with the whole.

#include <cmath>
#include <vector>

#include "core/physics/gauss.h"
#include "core/physics/vector.h"

namespace airlight {

inline physics::vec3 absolute(physics::vec3 v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
inline bool within(physics::vec3 error, physics::vec3 limit) {
  return error.x <= limit.x && error.y <= limit.y && error.z <= limit.z;
}

// `Value`: numbers side by side, with absolute() and within(); each is found to 1e-6 of its own integral. `Integrand`:
// yields the Value at a place.
template <class Value, class Integrand>
class AdaptiveSum {
 public:
  AdaptiveSum(const Integrand& f, const GaussRule& rule) : f_(f), rule_(rule) {}

  // The integral from the first to the last of these places, at which the integrand is not smooth.
  Value over(const std::vector<double>& corners) {
    std::vector<Value> panels;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      panels.push_back(panel(corners[k], corners[k + 1]));
      total_ = total_ + panels.back();
    }
    Value sum(0.0);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      sum = sum + refine(corners[k], corners[k + 1], panels[k], kMostLevels);
    }
    return sum;
  }

  // Whether the panels ran out before the integral was known.
  bool cut() const { return panels_ <= 0; }

 private:
  static constexpr double kTolerance = 1e-6;
  static constexpr double kNegligible = 1e-16;  // radiance, far below any night sky
  static constexpr int kMostLevels = 24;
  static constexpr int kMostPanels = 20000;  // an edge that is no corner takes some 50

  Value panel(double from, double to) const {
    Value sum(0.0);
    for (std::size_t k = 0; k < rule_.nodes.size(); ++k) {
      sum = sum + f_(from + (to - from) * rule_.nodes[k]) * rule_.weights[k];
    }
    return sum * (to - from);
  }

  // The total grows as peaks are found that the first nodes missed.
  Value refine(double from, double to, const Value& whole, int levels) {
    const double middle = 0.5 * (from + to);
    const Value first = panel(from, middle);
    const Value second = panel(middle, to);
    const Value both = first + second;
    total_ = total_ + both - whole;
    --panels_;
    if (levels == 0 || panels_ <= 0 ||
        within(absolute(both - whole), absolute(total_) * kTolerance + Value(kNegligible))) {
      return both;
    }
    const Value refined = refine(from, middle, first, levels - 1);
    return refined + refine(middle, to, second, levels - 1);
  }

  const Integrand& f_;
  const GaussRule& rule_;
  Value total_ = Value(0.0);  // best estimate of the integral so far
  int panels_ = kMostPanels;
};

}  // namespace airlight
