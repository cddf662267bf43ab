#include "core/air/phase_functions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/air/phase_samples.h"

namespace airlight {
namespace {

using physics::MediumData;
using physics::Physics;
using physics::uint;
using physics::vec3;

// [HG41], its usual inverse multiplied out so that nothing is divided by g.
double peaked_cosine(double g, double u) {
  const double a = 2.0 * u - 1.0;
  const double d = 1.0 + g * a;
  return (a + g * (0.5 * (a * a + 3.0) + g * (a + 0.5 * g * (a * a - 1.0)))) / (d * d);
}

// The moments of a formula, by samples that stand where a peaked one is large.
LegendreMoments formula_moments(Physics& p, uint kind, double g) {
  constexpr int kSamples = 4096;
  LegendreMoments moments{};
  for (int i = 0; i < kSamples; ++i) {
    const double nu = peaked_cosine(g, (i + 0.5) / kSamples);
    const double weight = p.phase_value(kind, g, nu) / p.phase_henyey_greenstein(g, nu);
    add_moments(moments, vec3(weight / kSamples), nu);
  }
  return moments;
}

LegendreMoments by_formula(Physics& p, uint medium) {
  return formula_moments(p, p.phase_of(medium), p.medium(medium).g);
}

LegendreMoments by_table(Physics& p, uint medium) {
  return table_moments(p, p.medium(medium).phase_table);
}

// A mixture of Rayleigh's function and the isotropic one, which has no moments above the first of all.
LegendreMoments by_mixture(Physics& p, uint medium) {
  LegendreMoments moments = formula_moments(p, Physics::kPhaseRayleigh, 0.0);
  const vec3 gamma = p.medium(medium).depolarization;
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] = moments[l] * (vec3(1.0) - gamma) / (vec3(1.0) + gamma * 2.0);
  }
  return moments;
}

double draw_isotropic(Physics& /*p*/, const MediumData& /*m*/, double u, const UniformNumbers& /*further*/) {
  return 2.0 * u - 1.0;
}

// Root of (4 + 3 nu + nu^3) / 8 = u by Cardano's formula.
double draw_rayleigh(Physics& /*p*/, const MediumData& /*m*/, double u, const UniformNumbers& /*further*/) {
  const double a = 4.0 * u - 2.0;
  const double root = std::cbrt(std::abs(a) + std::sqrt(a * a + 1.0));
  const double nu = root - 1.0 / root;
  return a < 0.0 ? -nu : nu;
}

// Isotropic with the mixture's share, else Rayleigh's.
double draw_mixture(Physics& p, const MediumData& m, double u, const UniformNumbers& further) {
  const double gamma = channel_mean(m.depolarization);
  const bool even = further() < 3.0 * gamma / (1.0 + 2.0 * gamma);
  return even ? draw_isotropic(p, m, u, further) : draw_rayleigh(p, m, u, further);
}

double draw_henyey_greenstein(Physics& /*p*/, const MediumData& m, double u, const UniformNumbers& /*further*/) {
  return peaked_cosine(m.g, u);
}

// [C92] is, up to a constant, Henyey-Greenstein times 1 + nu^2: the draw is accepted with a chance in proportion to it.
double draw_cornette_shanks(Physics& /*p*/, const MediumData& m, double u, const UniformNumbers& further) {
  while (true) {
    const double nu = peaked_cosine(m.g, u);
    if (2.0 * further() < 1.0 + nu * nu) {
      return nu;
    }
    u = further();
  }
}

// [S93], for its k.
double draw_schlick(Physics& p, const MediumData& m, double u, const UniformNumbers& /*further*/) {
  const double k = p.schlick_k(m.g);
  return (2.0 * u - 1.0 + k) / (1.0 - k + 2.0 * u * k);
}

// What the preset names, code, mean cosine, is smooth, by channel, moments, draw.
constexpr PhaseRow kPhaseRows[] = {
    {PhaseFunction::rayleigh, Physics::kPhaseRayleigh, MeanCosine::zero, true, false, by_formula, draw_rayleigh},
    {PhaseFunction::henyey_greenstein, Physics::kPhaseHenyeyGreenstein, MeanCosine::g, false, false, by_formula,
     draw_henyey_greenstein},
    {PhaseFunction::cornette_shanks, Physics::kPhaseCornetteShanks, MeanCosine::g, false, false, by_formula,
     draw_cornette_shanks},
    {PhaseFunction::schlick, Physics::kPhaseSchlick, MeanCosine::g, false, false, by_formula, draw_schlick},
    {PhaseFunction::isotropic, Physics::kPhaseIsotropic, MeanCosine::zero, true, false, by_formula, draw_isotropic},
    {PhaseFunction::table, Physics::kPhaseTable, MeanCosine::first_moment, false, true, by_table, nullptr},
    {PhaseFunction::rayleigh, Physics::kPhaseDepolarized, MeanCosine::zero, true, true, by_mixture, draw_mixture},
};
static_assert(std::size(kPhaseRows) <= physics::kPhaseCodes + 1, "a code has three bits");

constexpr bool stand_in_order() {
  for (uint k = 0; k < std::size(kPhaseRows); ++k) {
    if (kPhaseRows[k].code != k ||
        (k + 1 < std::size(kPhaseRows) && kPhaseRows[k].function != static_cast<PhaseFunction>(k))) {
      return false;
    }
  }
  return true;
}
static_assert(stand_in_order(), "a row's place is its code and its function's place in the enum");

}  // namespace

const PhaseRow& phase_row(uint code) {
  return kPhaseRows[code];
}

const PhaseRow& phase_row(PhaseFunction function) {
  return kPhaseRows[static_cast<std::size_t>(function)];
}

LegendreMoments legendre_moments(Physics& p, uint medium) {
  LegendreMoments moments = phase_row(p.phase_of(medium)).moments(p, medium);
  // The norm is known; dividing by the computed one takes most of a quadrature's error out.
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] = moments[l] / moments[0];
  }
  moments[0] = vec3(1.0);
  return moments;
}

vec3 mean_cosine(const Physics& p, uint medium) {
  switch (phase_row(p.phase_of(medium)).mean_cosine) {
    case MeanCosine::zero:
      return vec3(0.0);
    case MeanCosine::g:
      return vec3(p.medium(medium).g);
    case MeanCosine::first_moment:
      return p.medium(medium).legendre[1];
  }
  return vec3(0.0);
}

}  // namespace airlight
