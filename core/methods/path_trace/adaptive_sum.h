#pragma once
// An integral along a ray, by rules of 3, 7 and 15 nodes of which each holds the nodes of the one before (Kronrod 1964,
// Patterson 1968). A panel that 15 nodes do not settle is halved.

#include <array>
#include <cmath>
#include <vector>

#include "core/physics/vector.h"

namespace airlight {

inline physics::vec3 absolute(physics::vec3 v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
inline bool within(physics::vec3 error, physics::vec3 limit) {
  return error.x <= limit.x && error.y <= limit.y && error.z <= limit.z;
}

// A stretch of a ray within which the integrand is smooth, by distances.
struct SmoothPart {
  double from = 0.0;
  double to = 0.0;
};

// `Value`: numbers side by side, with absolute() and within(); each is found to 1e-6 of its own integral. `Integrand`:
// yields the Value at a distance.
template <class Value, class Integrand>
class AdaptiveSum {
 public:
  explicit AdaptiveSum(const Integrand& f) : f_(f) {}

  Value over(const std::vector<SmoothPart>& parts) {
    std::vector<Panel> panels;
    for (const SmoothPart& part : parts) {
      panels.push_back(panel(part.from, part.to));
      total_ = total_ + panels.back().by_seven;
    }
    Value sum(0.0);
    for (const Panel& each : panels) {
      sum = sum + refine(each, kMostLevels);
    }
    return sum;
  }

  // Whether the panels ran out before the integral was known.
  bool cut() const { return panels_ <= 0; }

 private:
  // Of what two rules differ by, which is about the error of the smaller one: that of the larger one is far less.
  static constexpr double kTolerance = 1e-6;
  static constexpr double kNegligible = 1e-16;  // radiance, far below any night sky
  static constexpr int kMostLevels = 24;
  static constexpr int kMostPanels = 20000;  // an edge that is no corner takes some 50

  // On [-1, 1], which is even: the node in the middle, then pairs outward.
  struct Node {
    double place;
    double three;
    double seven;
    double fifteen;
  };
  static constexpr std::array<Node, 8> kNodes{{
      {0.0, 8.0 / 9.0, 0.450916538658474142345, 0.225510499798206687},
      {0.434243749346802558002, 0.0, 0.401397414775962222905, 0.200628529376989021},
      {0.774596669241483377036, 5.0 / 9.0, 0.268488089868333440729, 0.134415255243784220},
      {0.960491268708020283424, 0.0, 0.104656226026467265194, 0.051603282997079740},
      {0.223386686428966882, 0.0, 0.0, 0.219156858401587496},
      {0.621102946737226403, 0.0, 0.0, 0.171511909136391381},
      {0.888459232872256999, 0.0, 0.0, 0.092927195315124538},
      {0.993831963212755022, 0.0, 0.0, 0.017001719629940260},
  }};
  static constexpr std::size_t kOfSeven = 4;  // the first nodes are those of the rule of 7

  struct Panel {
    SmoothPart part;
    Value by_seven;
    Value off;             // from the rule of 3
    Value toward_fifteen;  // what the nodes of the rule of 7 bring to that of 15
  };

  Value pair_at(const SmoothPart& part, const Node& node) const {
    const double middle = 0.5 * (part.from + part.to);
    const double aside = 0.5 * (part.to - part.from) * node.place;
    return node.place > 0.0 ? f_(middle - aside) + f_(middle + aside) : f_(middle);
  }

  Panel panel(double from, double to) const {
    Panel panel{{from, to}, Value(0.0), Value(0.0), Value(0.0)};
    Value three(0.0);
    const double half = 0.5 * (to - from);
    for (std::size_t k = 0; k < kOfSeven; ++k) {
      const Node& node = kNodes[k];
      const Value pair = pair_at(panel.part, node) * half;
      three = three + pair * node.three;
      panel.by_seven = panel.by_seven + pair * node.seven;
      panel.toward_fifteen = panel.toward_fifteen + pair * node.fifteen;
    }
    panel.off = absolute(panel.by_seven - three);
    return panel;
  }

  bool settles(const Value& off) const { return within(off, absolute(total_) * kTolerance + Value(kNegligible)); }

  // The total grows as peaks are found that the first nodes missed.
  Value refine(const Panel& whole, int levels) {
    if (settles(whole.off)) {
      return whole.by_seven;
    }
    Value sum = whole.toward_fifteen;
    const double half = 0.5 * (whole.part.to - whole.part.from);
    for (std::size_t k = kOfSeven; k < kNodes.size(); ++k) {
      sum = sum + pair_at(whole.part, kNodes[k]) * (half * kNodes[k].fifteen);
    }
    total_ = total_ + sum - whole.by_seven;
    --panels_;
    if (levels == 0 || panels_ <= 0 || settles(absolute(sum - whole.by_seven))) {
      return sum;
    }
    const double middle = 0.5 * (whole.part.from + whole.part.to);
    const Panel first = panel(whole.part.from, middle);
    const Panel second = panel(middle, whole.part.to);
    total_ = total_ + first.by_seven + second.by_seven - sum;
    const Value refined = refine(first, levels - 1);
    return refined + refine(second, levels - 1);
  }

  const Integrand& f_;
  Value total_ = Value(0.0);  // best estimate of the integral so far
  int panels_ = kMostPanels;
};

}  // namespace airlight
