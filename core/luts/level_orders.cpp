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

// One shell of one channel.
struct Shell {
  double height = 0.0;
  double extinction = 0.0;
  RowVectorXd scattering;  // by degree
};

std::vector<Shell> shells_of(Physics& p, std::size_t c) {
  std::vector<Shell> shells;
  for (physics::uint k = 0; k + 1 < p.shell_rows(); ++k) {
    const double low = p.shell_altitude(k);
    const double high = p.shell_altitude(k + 1);
    const auto air = p.diffuse_air(p.stretch_densities({.h = 0.5 * (low + high), .rise = high - low, .bulge = 0.0}),
                                   p.equal_phases(0.0));
    Shell shell{high - low, channel(air.extinction, c), RowVectorXd(kDegrees)};
    std::ranges::transform(air.degree, shell.scattering.begin(), [c](const physics::vec3& v) { return channel(v, c); });
    shells.push_back(shell);
  }
  return shells;
}

// Light that reaches a row along one zenith cosine: of what each row's moments of each degree send, and of what leaves
// the ground.
struct Arrival {
  MatrixXd from;  // row x degree
  double ground = 0.0;
};

Arrival arrival_at(Physics& p, const std::vector<Shell>& shells, std::size_t row, double mu, bool upward) {
  const auto rows = static_cast<Index>(shells.size()) + 1;
  Arrival arrival{MatrixXd::Zero(rows, kDegrees)};
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

// One order of scattering, a matrix for each m: from the moments by l, then by row, and for m = 0 from the ground's
// irradiance behind them.
class OneOrder {
 public:
  OneOrder(Physics& physics, Index rows, Index harmonics, double albedo)
      : physics_(physics), rows_(rows), harmonics_(harmonics), albedo_(albedo) {
    for (Index m = 0; m < harmonics; ++m) {
      const Index size = (harmonics - m) * rows + (m == 0 ? 1 : 0);
      by_m_.emplace_back(MatrixXd::Zero(size, size));
    }
  }

  // What arrives at a row out of a direction of so much solid angle over 2 pi.
  void gather(Index row, const Physics::Harmonics& y, double share, const Arrival& arrival) {
    for (Index m = 0; m < harmonics_; ++m) {
      MatrixXd& order = by_m_[static_cast<std::size_t>(m)];
      const double angle = share * (m == 0 ? 2.0 * std::numbers::pi : std::numbers::pi);
      for (Index to = m; to < harmonics_; ++to) {
        const double taken = angle * harmonic(y, to, m);
        add_sent(order.row((to - m) * rows_ + row), m, taken, y, arrival);
        if (m == 0) {
          order(to * rows_ + row, order.cols() - 1) += taken * arrival.ground * albedo_ / std::numbers::pi;
        }
      }
    }
  }

  // What arrives on the ground.
  void gather_irradiance(const Physics::Harmonics& y, double share, double mu, const Arrival& arrival) {
    MatrixXd& order = by_m_.front();
    add_sent(order.row(order.rows() - 1), 0, share * 2.0 * std::numbers::pi * mu, y, arrival);
  }

  const std::vector<MatrixXd>& by_m() const { return by_m_; }

 private:
  double harmonic(const Physics::Harmonics& y, Index l, Index m) const {
    return y.of[physics_.moment_place(static_cast<physics::uint>(l), static_cast<physics::uint>(m))];
  }

  template <class Row>
  void add_sent(Row&& into, Index m, double part, const Physics::Harmonics& y, const Arrival& arrival) const {
    for (Index l = m; l < harmonics_; ++l) {
      into.segment((l - m) * rows_, rows_) += part * harmonic(y, l, m) * arrival.from.col(l).transpose();
    }
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
        const Physics::Harmonics y = p.harmonics(upward ? mu : -mu, 1.0);
        order.gather(static_cast<Index>(row), y, share, arrival);
        if (row == 0 && upward) {
          order.gather_irradiance(y, share, mu, arrival);
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
  std::size_t sum = static_cast<std::size_t>(degree + 1) * r * 2 + 1;  // to and from the irradiance
  for (auto n = static_cast<std::size_t>(degree + 1); n > 0; --n) {
    sum += n * n * r * r;
  }
  return sum;
}

std::vector<float> level_orders(const Air& air, const LevelShape& shape, int table_degree, bool delta, double lost) {
  Physics p = air.formulas();
  p.degree = static_cast<physics::uint>(table_degree);
  p.delta = delta;
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
