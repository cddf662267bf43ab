#include "core/air/phase_functions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>

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

constexpr auto by_formula = [](Physics& p, uint i) { return formula_moments(p, p.phase_of(i), p.medium(i).g); };
constexpr auto by_table = [](Physics& p, uint i) { return table_moments(p, p.medium(i).phase_table); };

// A mixture of Rayleigh's function and the isotropic one, which has no moments above the first of all.
LegendreMoments by_mixture(Physics& p, uint medium) {
  LegendreMoments moments = formula_moments(p, Physics::kPhaseRayleigh, 0.0);
  for (std::size_t l = 1; l < moments.size(); ++l) {
    moments[l] = moments[l] * p.dipole_share(medium);
  }
  return moments;
}

// Draws: formulas, medium, u, further numbers.
constexpr auto draw_isotropic = [](auto&, auto&, double u, auto&) { return 2.0 * u - 1.0; };
constexpr auto draw_henyey_greenstein = [](auto&, auto& m, double u, auto&) { return peaked_cosine(m.g, u); };

// Root of (4 + 3 nu + nu^3) / 8 = u by Cardano's formula.
constexpr auto draw_rayleigh = [](auto&, auto&, double u, auto&) {
  const double a = 4.0 * u - 2.0;
  const double root = std::cbrt(std::abs(a) + std::sqrt(a * a + 1.0));
  const double nu = root - 1.0 / root;
  return a < 0.0 ? -nu : nu;
};

// Isotropic with the mixture's share, else Rayleigh's.
constexpr auto draw_mixture = [](auto& p, auto& m, double u, auto& further) {
  const double gamma = channel_mean(m.depolarization);
  const bool even = further() < 3.0 * gamma / (1.0 + 2.0 * gamma);
  return even ? draw_isotropic(p, m, u, further) : draw_rayleigh(p, m, u, further);
};

// [C92] is, up to a constant, Henyey-Greenstein times 1 + nu^2: the draw is accepted with a chance in proportion to it.
constexpr auto draw_cornette_shanks = [](auto&, auto& m, double u, auto& further) {
  double nu = peaked_cosine(m.g, u);
  while (2.0 * further() >= 1.0 + nu * nu) {
    nu = peaked_cosine(m.g, further());
  }
  return nu;
};

// [S93], for its k.
constexpr auto draw_schlick = [](auto& p, auto& m, double u, auto&) {
  const double k = p.schlick_k(m.g);
  return (2.0 * u - 1.0 + k) / (1.0 - k + 2.0 * u * k);
};

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
static_assert(std::size(kPhaseRows) == kPhaseNames.size(), "a row for each name, the last for \"drops\": depolarized");
static_assert(std::size(kPhaseRows) <= physics::kPhaseCodes + 1, "a code has three bits");

static_assert(std::ranges::equal(kPhaseRows, std::views::iota(0U, std::size(kPhaseRows)), {}, &PhaseRow::code));
static_assert(std::ranges::all_of(kPhaseRows, [](const PhaseRow& row) {
  return row.function == static_cast<PhaseFunction>(row.code) || &row + 1 == std::end(kPhaseRows);
}));

}  // namespace

const PhaseRow& phase_row(uint code) {
  return kPhaseRows[code];
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
  const MeanCosine is = phase_row(p.phase_of(medium)).mean_cosine;
  const MediumData m = p.medium(medium);
  return is == MeanCosine::first_moment ? m.legendre[1] : vec3(is == MeanCosine::g ? m.g : 0.0);
}

}  // namespace airlight
