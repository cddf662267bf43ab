#include "core/luts/level_orders.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics/gauss.h"

namespace airlight {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using physics::Physics;

constexpr int kNodes = 8;  // zenith cosines a hemisphere, dense at the horizon
constexpr Index kDegrees = physics::kMaxDegree + 1;
constexpr Index kPolarised = physics::kPolarisedMoments;

// One shell of one channel.
struct Shell {
  double height = 0.0;
  double extinction = 0.0;
  RowVectorXd scattering;  // by degree, then what dipoles scatter of P_m
};

std::vector<Shell> shells_of(Physics& p, std::size_t c) {
  std::vector<Shell> shells;
  for (physics::uint k = 0; k + 1 < p.shell_rows(); ++k) {
    const double low = p.shell_altitude(k);
    const double high = p.shell_altitude(k + 1);
    const auto air = p.diffuse_air(p.stretch_densities({.h = 0.5 * (low + high), .rise = high - low, .bulge = 0.0}),
                                   p.equal_phases(0.0));
    Shell shell{high - low, channel(air.extinction, c), RowVectorXd(kDegrees + 1)};
    std::ranges::transform(air.degree, shell.scattering.begin(), [c](const physics::vec3& v) { return channel(v, c); });
    shell.scattering[kDegrees] = channel(air.dipoles, c) * p.kDipoleMoment;
    shells.push_back(shell);
  }
  return shells;
}

// Light that reaches a row along one zenith cosine: of what each row's moments of each degree send, and of what leaves
// the ground.
struct Arrival {
  MatrixXd from;  // row x columns of Shell::scattering
  double ground = 0.0;
};

Arrival arrival_at(Physics& p, const std::vector<Shell>& shells, std::size_t row, double mu, bool upward) {
  const auto rows = static_cast<Index>(shells.size()) + 1;
  Arrival arrival{MatrixXd::Zero(rows, kDegrees + 1)};
  double through = 1.0;
  const std::size_t count = upward ? shells.size() - row : row;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = upward ? row + i : row - 1 - i;
    const Shell& shell = shells[k];
    const double depth = shell.extinction * shell.height / mu;
    const RowVectorXd sent = (through * p.mean_transmittance(depth) * shell.height / mu) * shell.scattering;
    const double far = p.source_place(depth);
    const auto below = static_cast<Index>(k);
    arrival.from.row(below) += sent * (upward ? 1.0 - far : far);
    arrival.from.row(below + 1) += sent * (upward ? far : 1.0 - far);
    through *= std::exp(-depth);
  }
  arrival.ground = upward ? 0.0 : through;
  return arrival;
}

// How the moments of one m see light from a zenith cosine, and send it there: the factors of its azimuth's cosine and
// sine. By l from m on, then of P_m, where there is one, Q and U.
struct Patterns {
  std::vector<double> intensity;
  double q = 0.0;
  double u = 0.0;

  // Mean over the azimuth, but for a factor of the m.
  double product(std::size_t a, std::size_t b, bool polarised) const {
    return intensity[a] * intensity[b] + (polarised ? q * q + u * u : 0.0);
  }
};

// One order of scattering, a matrix for each m: from the moments by l, then P_m, each by row, and for m = 0 from the
// ground's irradiance behind them.
class OneOrder {
 public:
  OneOrder(Physics& physics, Index rows, Index harmonics, double albedo)
      : physics_(physics), rows_(rows), harmonics_(harmonics), albedo_(albedo) {
    for (Index m = 0; m < harmonics; ++m) {
      const Index size = (harmonics - m + (has_polarised(m) ? 1 : 0)) * rows + (m == 0 ? 1 : 0);
      by_m_.emplace_back(MatrixXd::Zero(size, size));
    }
  }

  // What arrives at a row out of a direction of so much solid angle over 2 pi.
  void gather(Index row, double mu, double share, const Arrival& arrival) {
    for (Index m = 0; m < harmonics_; ++m) {
      MatrixXd& order = by_m_[static_cast<std::size_t>(m)];
      const Patterns patterns = patterns_of(mu, m);
      const double angle = share * (m == 0 ? 2.0 * std::numbers::pi : std::numbers::pi);
      const std::size_t count = patterns.intensity.size();
      for (std::size_t to = 0; to < count; ++to) {
        auto into = order.row(static_cast<Index>(to) * rows_ + row);
        for (std::size_t from = 0; from < count; ++from) {
          const bool both = has_polarised(m) && to + 1 == count && from + 1 == count;
          add_sent(into, m, from, angle * patterns.product(to, from, both), arrival);
        }
        if (m == 0) {
          into(order.cols() - 1) += angle * patterns.intensity[to] * arrival.ground * albedo_ / std::numbers::pi;
        }
      }
    }
  }

  // What arrives on the ground.
  void gather_irradiance(double share, double mu, const Arrival& arrival) {
    MatrixXd& order = by_m_.front();
    const Patterns patterns = patterns_of(mu, 0);
    for (std::size_t from = 0; from < patterns.intensity.size(); ++from) {
      add_sent(order.row(order.rows() - 1), 0, from, share * 2.0 * std::numbers::pi * mu * patterns.intensity[from],
               arrival);
    }
  }

  const std::vector<MatrixXd>& by_m() const { return by_m_; }

 private:
  bool has_polarised(Index m) const { return physics_.polarised() && m < kPolarised; }

  Patterns patterns_of(double mu, Index m) const {
    const Physics::Harmonics y = physics_.harmonics(mu, 1.0);
    const auto harmonic = [&](Index l) {
      return y.of[physics_.moment_place(static_cast<physics::uint>(l), static_cast<physics::uint>(m))];
    };
    Patterns patterns;
    for (Index l = m; l < harmonics_; ++l) {
      patterns.intensity.push_back(harmonic(l));
    }
    if (has_polarised(m)) {
      patterns.intensity.push_back(harmonic(2));
      patterns.q = physics_.quadrupole(mu, 1.0).e[m];
      // Of the sine of m times the azimuth.
      const double aside = m == 0 ? 0.0 : std::cos(0.25 * std::numbers::pi);
      patterns.u = m == 0 ? 0.0 : m == 1 ? physics_.quadrupole(mu, 0.0).f[1] : physics_.quadrupole(mu, aside).f[2];
    }
    return patterns;
  }

  // Adds what unknown `from` of this m sends along the direction.
  template <class Row>
  void add_sent(Row&& into, Index m, std::size_t from, double part, const Arrival& arrival) const {
    const auto k = static_cast<Index>(from);
    const Index column = m + k < harmonics_ ? m + k : kDegrees;
    into.segment(k * rows_, rows_) += part * arrival.from.col(column).transpose();
  }

  Physics& physics_;
  Index rows_;
  Index harmonics_;
  double albedo_;
  std::vector<MatrixXd> by_m_;
};

OneOrder one_order(Physics& p, const std::vector<Shell>& shells, Index harmonics, double albedo) {
  OneOrder order(p, static_cast<Index>(shells.size()) + 1, harmonics, albedo);
  const GaussRule gauss = gauss_legendre(kNodes);
  for (std::size_t row = 0; row <= shells.size(); ++row) {
    for (std::size_t node = 0; node < gauss.nodes.size(); ++node) {
      const double mu = gauss.nodes[node] * gauss.nodes[node];
      const double share = 2.0 * gauss.nodes[node] * gauss.weights[node];
      for (const bool upward : {true, false}) {
        const Arrival arrival = arrival_at(p, shells, row, mu, upward);
        order.gather(static_cast<Index>(row), upward ? mu : -mu, share, arrival);
        if (row == 0 && upward) {
          order.gather_irradiance(share, mu, arrival);
        }
      }
    }
  }
  return order;
}

// (1 - order)^-1 - 1: every order after the first.
MatrixXd all_orders(const MatrixXd& order) {
  const auto one = MatrixXd::Identity(order.rows(), order.cols());
  return (one - order).partialPivLu().inverse() - one;
}

}  // namespace

std::size_t LevelShape::values() const {
  const auto r = static_cast<std::size_t>(rows);
  std::size_t sum = 1;
  for (int m = 0; m <= degree; ++m) {
    const auto n = static_cast<std::size_t>(degree + 1 - m + (polarised && m < static_cast<int>(kPolarised) ? 1 : 0));
    sum += n * n * r * r + (m == 0 ? 2 * n * r : 0);  // to and from the irradiance
  }
  return sum;
}

std::vector<float> level_orders(const Air& air, const LevelShape& shape, int table_degree, bool delta, double lost) {
  Physics p = air.formulas();
  p.degree = static_cast<physics::uint>(table_degree);
  p.delta = delta;
  p.polarisation = shape.polarised;
  std::vector<float> values(3 * shape.values());
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t at = c;
    const auto put = [&](double value) {
      values[at] = static_cast<float>(value);
      at += 3;
    };
    RowVectorXd to_irradiance;
    const OneOrder order = one_order(p, shells_of(p, c), shape.degree + 1, air.planet().ground_albedo[c]);
    for (const MatrixXd& of_m : order.by_m()) {
      MatrixXd all = all_orders((1.0 - lost) * of_m);
      if (to_irradiance.size() == 0) {
        to_irradiance = all.bottomRows(1);
        all.conservativeResize(all.rows() - 1, all.cols());
      }
      std::ranges::for_each(all.reshaped(), put);
    }
    std::ranges::for_each(to_irradiance, put);
  }
  return values;
}

}  // namespace airlight
