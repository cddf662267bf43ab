#include "core/scene/angle.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/scene/json_format.h"

namespace airlight {

double radians_from_degrees(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

double degrees_from_radians(double radians) {
  // The multiplication there and the division back are each wrong by half an ulp, so the wanted number is at most a few
  // neighbours away.
  constexpr int kNeighbours = 4;
  if (radians == 0.0) {
    return radians;  // its neighbours are denormal numbers that round to it
  }
  const double nearest = radians * (180.0 / std::numbers::pi);
  double best = nearest;
  std::size_t best_length = std::numeric_limits<std::size_t>::max();
  double candidate = nearest;
  for (int i = 0; i < kNeighbours; ++i) {
    candidate = std::nextafter(candidate, -std::numeric_limits<double>::infinity());
  }
  for (int i = -kNeighbours; i <= kNeighbours; ++i) {
    if (radians_from_degrees(candidate) == radians && format_number(candidate).size() < best_length) {
      best = candidate;
      best_length = format_number(candidate).size();
    }
    candidate = std::nextafter(candidate, std::numeric_limits<double>::infinity());
  }
  return best;
}

}  // namespace airlight
