#include "core/air/legendre.h"

#include <algorithm>
#include <cmath>

#include "core/air/phase_samples.h"

namespace airlight {
namespace {

using physics::vec3;

// Henyey-Greenstein's inverse distribution: samples stand where a peaked phase function is large.
double peaked_cosine(double g, double u) {
  if (std::abs(g) < 1e-3) {
    return 2.0 * u - 1.0;
  }
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

// The moments of a formula, by samples that stand where it is large.
LegendreMoments formula_moments(physics::Physics& p, physics::uint kind, double g) {
  constexpr int kSamples = 4096;
  LegendreMoments moments{};
  for (int i = 0; i < kSamples; ++i) {
    const double nu = peaked_cosine(g, (i + 0.5) / kSamples);
    const double weight = p.phase_value(kind, g, nu) / p.phase_henyey_greenstein(std::abs(g) < 1e-3 ? 0.0 : g, nu);
    add_moments(moments, vec3(weight / kSamples), nu);
  }
  return moments;
}

}  // namespace

void add_moments(LegendreMoments& moments, vec3 light, double nu) {
  for_each_polynomial(moments.size(), nu, [&](std::size_t l, double p) { moments[l] = moments[l] + light * p; });
}

LegendreMoments legendre_moments(physics::Physics& p, physics::uint medium) {
  const physics::MediumData m = p.medium(medium);
  const physics::uint kind = p.phase_of(medium);
  LegendreMoments moments;
  if (kind == physics::kPhaseTable) {
    moments = table_moments(p, m.phase_table);
  } else if (kind == physics::kPhaseDepolarized) {
    // A mixture of Rayleigh's function and the isotropic one, which has no moments above the first of all.
    moments = formula_moments(p, physics::kPhaseRayleigh, 0.0);
    for (std::size_t l = 1; l < moments.size(); ++l) {
      moments[l] = moments[l] * (vec3(1.0) - m.depolarization) / (vec3(1.0) + m.depolarization * 2.0);
    }
  } else {
    moments = formula_moments(p, kind, m.g);
  }
  // The norm is known; dividing by the sampled one takes most of the quadrature's error out.
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] = moments[l] / moments[0];
  }
  moments[0] = vec3(1.0);
  return moments;
}

}  // namespace airlight
