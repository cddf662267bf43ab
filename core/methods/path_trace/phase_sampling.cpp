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

namespace {

constexpr double kPeaked = 0.3;  // mean cosine, forward or back

}  // namespace

PhaseSampler::PhaseSampler(physics::Physics& physics) : physics_(physics) {
  tables_.resize(physics.medium_count());
  for (physics::uint i = 0; i < physics.medium_count(); ++i) {
    if (physics.phase_of(i) == Physics::kPhaseTable) {
      const auto fill = [](Table& table, std::vector<double> shares) {
        table.shares = std::move(shares);
        std::partial_sum(table.shares.begin(), table.shares.end(), std::back_inserter(table.ends));
      };
      const physics::uint samples = physics.medium(i).phase_table;
      fill(tables_[i].mean, interval_shares(physics, samples));
      std::array<std::vector<double>, 3> own = channel_interval_shares(physics, samples);
      for (std::size_t c = 0; c < own.size(); ++c) {
        fill(tables_[i].of_channel[c], std::move(own[c]));
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

double PhaseSampler::sample(physics::uint medium, double u, Random& random) const {
  const auto& draw_by = phase_row(physics_.phase_of(medium)).draw;
  const double nu = draw_by == nullptr
                        ? tables_[medium].mean.draw_cosine(u)
                        : draw_by(physics_, physics_.medium(medium), u, [&random] { return random.uniform(); });
  return std::clamp(nu, -1.0, 1.0);
}

double PhaseSampler::density(physics::uint medium, double nu, vec3 phase) const {
  const physics::uint kind = physics_.phase_of(medium);
  if (kind == Physics::kPhaseDepolarized) {
    return physics_.phase_depolarized(vec3(channel_mean(physics_.medium(medium).depolarization)), nu).x;
  }
  if (kind == Physics::kPhaseTable) {
    const Table& table = tables_[medium].mean;
    const std::size_t k = std::min(static_cast<std::size_t>(physics_.phase_table_place(nu)), table.shares.size() - 1);
    const double width = 2.0 * std::numbers::pi * (sample_cosine(k) - sample_cosine(k + 1));
    return table.shares[k] / (table.ends.back() * width);
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
  return std::clamp(tables_[medium].of_channel[channel].draw_cosine(left), -1.0, 1.0);
}

double PhaseSampler::density_by(const std::array<double, 3>& weights, physics::uint medium, double nu,
                                vec3 phase) const {
  if (physics_.phase_of(medium) != Physics::kPhaseTable) {
    return density(medium, nu, phase);
  }
  const std::array<Table, 3>& tables = tables_[medium].of_channel;
  const std::size_t k = std::min(static_cast<std::size_t>(physics_.phase_table_place(nu)), tables[0].shares.size() - 1);
  const double width = 2.0 * std::numbers::pi * (sample_cosine(k) - sample_cosine(k + 1));
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    sum += weights[c] * tables[c].shares[k] / tables[c].ends.back();
  }
  return sum / ((weights[0] + weights[1] + weights[2]) * width);
}

double PhaseSampler::dipole_share(physics::uint medium) const {
  const double gamma = channel_mean(physics_.medium(medium).depolarization);
  return (1.0 - gamma) / (1.0 + 2.0 * gamma);
}

bool PhaseSampler::is_peaked(physics::uint medium) const {
  return std::abs(channel_mean(mean_cosine(physics_, medium))) > kPeaked;
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
