#pragma once
// Linearly polarised light in the terms that people measure.

#include <cmath>
#include <numbers>

namespace airlight {

struct Polarisation {
  double degree = 0.0;     // share of the light that is polarised
  double angle_deg = 0.0;  // of its swing from the plane of direction and zenith, -90 to 90, as U leans
};

// Of Stokes parameters. Where there is no light, none is polarised.
inline Polarisation polarisation_of(double i, double q, double u) {
  return {i > 0.0 ? std::hypot(q, u) / i : 0.0, 0.5 * std::atan2(u, q) * 180.0 / std::numbers::pi};
}

}  // namespace airlight
