#include "core/air/legendre.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

// Henyey-Greenstein's inverse distribution: samples stand where a peaked phase function is large.
double peaked_cosine(double g, double u) {
  if (std::abs(g) < 1e-3) {
    return 2.0 * u - 1.0;
  }
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

}  // namespace

LegendreMoments legendre_moments(physics::Physics& p, physics::uint phase_code, double g) {
  constexpr int kSamples = 4096;
  LegendreMoments moments{};
  for (int i = 0; i < kSamples; ++i) {
    const double nu = peaked_cosine(g, (i + 0.5) / kSamples);
    const double weight =
        p.phase_value(phase_code, g, nu) / p.phase_henyey_greenstein(std::abs(g) < 1e-3 ? 0.0 : g, nu);
    double before = 1.0;
    double polynomial = nu;
    moments[0] += weight / kSamples;
    for (std::size_t l = 1; l < moments.size(); ++l) {
      moments[l] += weight * polynomial / kSamples;
      const double n = static_cast<double>(l);
      const double next = ((2.0 * n + 1.0) * nu * polynomial - n * before) / (n + 1.0);
      before = polynomial;
      polynomial = next;
    }
  }
  // The norm is known; dividing by the sampled one takes most of the quadrature's error out.
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] /= moments[0];
  }
  moments[0] = 1.0;
  return moments;
}

}  // namespace airlight
