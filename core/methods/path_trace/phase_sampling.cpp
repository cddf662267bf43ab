#include "core/methods/path_trace/phase_sampling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/air/phase_functions.h"
#include "core/air/phase_samples.h"

namespace airlight {

using physics::Physics;
using physics::vec3;

PhaseSampler::PhaseSampler(physics::Physics& physics) : physics_(physics) {
  tables_.resize(physics.medium_count());
  for (physics::uint i = 0; i < physics.medium_count(); ++i) {
    if (physics.phase_of(i) == Physics::kPhaseTable) {
      std::array<std::vector<double>, 4> shares = interval_shares(physics, physics.medium(i).phase_table);
      for (std::size_t k = 0; k < shares.size(); ++k) {
        std::partial_sum(shares[k].begin(), shares[k].end(), std::back_inserter(tables_[i][k].ends));
        tables_[i][k].shares = std::move(shares[k]);
      }
    }
  }
}

double PhaseSampler::Table::draw_cosine(double u) const {
  const double at = u * ends.back();
  const auto found = std::upper_bound(ends.begin(), ends.end() - 1, at);
  const auto k = static_cast<std::size_t>(found - ends.begin());
  const double share = std::clamp(1.0 - (ends[k] - at) / shares[k], 0.0, 1.0);
  return sample_cosine(k) * (1.0 - share) + sample_cosine(k + 1) * share;
}

PhaseSampler::Interval PhaseSampler::interval_at(double nu) const {
  const std::size_t k =
      std::min<std::size_t>(static_cast<std::size_t>(physics_.phase_table_place(nu)), physics::kPhaseSamples - 2);
  return {k, 2.0 * std::numbers::pi * (sample_cosine(k) - sample_cosine(k + 1))};
}

double PhaseSampler::sample(physics::uint medium, double u, Random& random) const {
  const auto& draw_by = phase_row(physics_.phase_of(medium)).draw;
  const double nu = draw_by == nullptr
                        ? tables_[medium][3].draw_cosine(u)
                        : draw_by(physics_, physics_.medium(medium), u, [&random] { return random.uniform(); });
  return std::clamp(nu, -1.0, 1.0);
}

double PhaseSampler::density(physics::uint medium, double nu, vec3 phase) const {
  const physics::uint kind = physics_.phase_of(medium);
  if (kind == Physics::kPhaseDepolarized) {
    return physics_.phase_depolarized(vec3(channel_mean(physics_.medium(medium).depolarization)), nu).x;
  }
  if (kind == Physics::kPhaseTable) {
    const Table& table = tables_[medium][3];
    const Interval in = interval_at(nu);
    return table.shares[in.index] / (table.ends.back() * in.width);
  }
  return phase.x;
}

double PhaseSampler::sample_by(const std::array<double, 3>& weights, physics::uint medium, double u,
                               Random& random) const {
  if (physics_.phase_of(medium) != Physics::kPhaseTable) {
    return sample(medium, u, random);
  }
  double left = u * (weights[0] + weights[1] + weights[2]);
  const std::size_t channel = draw(
      3, [&](std::size_t c) { return weights[c]; }, left);
  return std::clamp(tables_[medium][channel].draw_cosine(left), -1.0, 1.0);
}

double PhaseSampler::density_by(const std::array<double, 3>& weights, physics::uint medium, double nu,
                                vec3 phase) const {
  if (physics_.phase_of(medium) != Physics::kPhaseTable) {
    return density(medium, nu, phase);
  }
  const Interval in = interval_at(nu);
  double sum = 0.0;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    sum += weights[c] * tables_[medium][c].shares[in.index] / tables_[medium][c].ends.back();
  }
  return sum / ((weights[0] + weights[1] + weights[2]) * in.width);
}

double PhaseSampler::dipole_share(physics::uint medium) const {
  const double gamma = channel_mean(physics_.medium(medium).depolarization);
  return (1.0 - gamma) / (1.0 + 2.0 * gamma);
}

bool PhaseSampler::is_peaked(physics::uint medium) const {
  return std::abs(channel_mean(mean_cosine(physics_, medium))) > 0.3;
}

vec3 around(vec3 axis, double nu, double turn) {
  const double sine = std::sqrt(std::max((1.0 - nu) * (1.0 + nu), 0.0));
  // Two axes across, by a form that loses no digits (Duff et al. 2017).
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1.0 / (sign + axis.z);
  const double b = axis.x * axis.y * a;
  const vec3 first(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
  const vec3 second(b, sign + axis.y * axis.y * a, -axis.y);
  const double angle = 2.0 * std::numbers::pi * turn;
  return normalize(axis * nu + first * (sine * std::cos(angle)) + second * (sine * std::sin(angle)));
}

}  // namespace airlight
