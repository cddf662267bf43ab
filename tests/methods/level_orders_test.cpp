// All orders of scattering in level air: against fields that are known in closed form, and against orders summed one by
// one, each gathered along finely divided rays.
#include "core/luts/level_orders.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "core/physics/gauss.h"
#include "tests/methods/path_trace_scene.h"

namespace airlight {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double kDepth = 0.8;
constexpr double kAsymmetry = 0.6;
constexpr int kHarmonics = 3;  // degrees 0 to 2

struct Level {
  Air air;
  LevelShape shape;
  std::vector<double> altitudes;
};

Level level_air(double single_scattering_albedo, double ground_albedo) {
  Scene scene = slab(kDepth, single_scattering_albedo, PhaseFunction::henyey_greenstein, kAsymmetry);
  scene.planet.ground_albedo = {ground_albedo, ground_albedo, ground_albedo};
  AirOptions options;
  options.shells = Shells::always;
  Level level{Air(scene.media, scene.planet, options), {}, {}};
  physics::Physics p = level.air.formulas();
  for (physics::uint k = 0; k < p.shell_rows(); ++k) {
    level.altitudes.push_back(p.shell_altitude(k));
  }
  level.shape = {static_cast<int>(level.altitudes.size()), kHarmonics - 1};
  return level;
}

// Green's values as a matrix for one m: first the moments by l, each by row, and for m = 0 the irradiance after them.
MatrixXd matrix_of(const Level& level, int m, double lost) {
  const std::vector<float> values = level_orders(level.air, level.shape, 8, false, lost);
  EXPECT_EQ(values.size(), 3 * level.shape.values());
  const Index rows = level.shape.rows;
  std::size_t at = 1;
  const auto next = [&] {
    at += 3;
    return static_cast<double>(values.at(at - 3));
  };
  for (int before = 0; before < m; ++before) {
    const Index moments = (kHarmonics - before) * rows;
    at += static_cast<std::size_t>(3 * moments * (moments + (before == 0 ? 1 : 0)));
  }
  const Index moments = (kHarmonics - m) * rows;
  MatrixXd all(moments + (m == 0 ? 1 : 0), moments + (m == 0 ? 1 : 0));
  for (Index from = 0; from < all.cols(); ++from) {
    for (Index to = 0; to < moments; ++to) {
      all(to, from) = next();
    }
  }
  if (m == 0) {
    at = values.size() + 1 - static_cast<std::size_t>(3 * all.cols());
    for (Index from = 0; from < all.cols(); ++from) {
      all(moments, from) = next();
    }
  }
  return all;
}

// The part of the orthonormal cosine harmonics over the zenith cosine of the direction that light comes from.
double harmonic(int l, int m, double mu) {
  const double theta = std::acos(mu);
  return std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m), theta) *
         (m == 0 ? 1.0 : std::numbers::sqrt2);
}

// Calls use(mu, share of a unit of mu) over one hemisphere.
template <class Use>
void over_cosines(const Use& use) {
  const GaussRule rule = gauss_legendre(40);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    use(rule.nodes[i] * rule.nodes[i], 2.0 * rule.nodes[i] * rule.weights[i]);
  }
}

// Light that enters only at the top, equal from all directions, over white ground and through air without absorption,
// is equal everywhere, however it is scattered. The orders add exactly what the unscattered light lacks of that.
TEST(LevelOrders, LightFromEverywhereStaysLightFromEverywhere) {
  const Level level = level_air(1.0, 1.0);
  const Index rows = level.shape.rows;
  VectorXd source = VectorXd::Zero(kHarmonics * rows + 1);
  VectorXd all = VectorXd::Zero(source.size());
  for (Index row = 0; row < rows; ++row) {
    const double above = kDepth * (1.0 - level.altitudes[static_cast<std::size_t>(row)] / 10.0);
    over_cosines([&](double mu, double share) {
      for (int l = 0; l < kHarmonics; ++l) {
        source[l * rows + row] += share * 2.0 * pi * harmonic(l, 0, mu) * std::exp(-above / mu);
      }
    });
    all[row] = std::sqrt(4.0 * pi);
  }
  over_cosines(
      [&](double mu, double share) { source[source.size() - 1] += share * 2.0 * pi * mu * std::exp(-kDepth / mu); });
  all[all.size() - 1] = pi;
  const VectorXd found = matrix_of(level, 0, 0.0) * source + source;
  for (Index i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(found[i] / std::sqrt(4.0 * pi), all[i] / std::sqrt(4.0 * pi), 2e-3) << i;
  }
}

// One order by rays in many short pieces, with straight lines between rows.
MatrixXd one_order(const Level& level, int m, double single_scattering_albedo, double ground_albedo) {
  constexpr int kPieces = 64;
  const Index rows = level.shape.rows;
  const Index degrees = kHarmonics - m;
  const Index irradiance = degrees * rows;
  MatrixXd order = MatrixXd::Zero(degrees * rows + (m == 0 ? 1 : 0), degrees * rows + (m == 0 ? 1 : 0));
  const double extinction = kDepth / 10.0;
  const double angle = m == 0 ? 2.0 * pi : pi;
  for (Index row = 0; row < rows; ++row) {
    const double h = level.altitudes[static_cast<std::size_t>(row)];
    over_cosines([&](double mu, double share) {
      for (const bool upward : {true, false}) {
        const double toward = upward ? mu : -mu;
        VectorXd sent = VectorXd::Zero(rows);  // for each row: dimmed path length, by its share of each piece
        for (Index k = 0; k + 1 < rows; ++k) {
          const double low = level.altitudes[static_cast<std::size_t>(k)];
          const double width = level.altitudes[static_cast<std::size_t>(k) + 1] - low;
          if (upward != (low >= h)) {
            continue;
          }
          for (int i = 0; i < kPieces; ++i) {
            const double part = (i + 0.5) / kPieces;
            const double seen = std::exp(-extinction * std::abs(low + part * width - h) / mu) * width / kPieces / mu;
            sent[k] += seen * (1.0 - part);
            sent[k + 1] += seen * part;
          }
        }
        const double ground = upward ? 0.0 : std::exp(-extinction * h / mu) * ground_albedo / pi;
        for (int to = m; to < kHarmonics; ++to) {
          const double taken = share * angle * harmonic(to, m, toward);
          for (int l = m; l < kHarmonics; ++l) {
            const double scattered = extinction * single_scattering_albedo * std::pow(kAsymmetry, l);
            order.row((to - m) * rows + row).segment((l - m) * rows, rows) +=
                taken * scattered * harmonic(l, m, toward) * sent.transpose();
          }
          if (m == 0) {
            order(to * rows + row, irradiance) += taken * ground;
          }
        }
        for (int l = 0; m == 0 && upward && row == 0 && l < kHarmonics; ++l) {
          const double scattered = extinction * single_scattering_albedo * std::pow(kAsymmetry, l);
          order.row(irradiance).segment(l * rows, rows) +=
              share * 2.0 * pi * mu * scattered * harmonic(l, 0, mu) * sent.transpose();
        }
      }
    });
  }
  return order;
}

TEST(LevelOrders, AreTheSumOfOrdersOneByOne) {
  constexpr double kLost = 0.05;
  const Level level = level_air(0.9, 0.3);
  for (int m = 0; m < kHarmonics; ++m) {
    const MatrixXd order = (1.0 - kLost) * one_order(level, m, 0.9, 0.3);
    VectorXd source = VectorXd::Ones(order.rows());  // equal in all unknowns, but larger at the top
    source.tail(order.rows() / 2) *= 2.0;
    VectorXd last = source;
    VectorXd sum = VectorXd::Zero(source.size());
    for (int n = 0; n < 60; ++n) {
      last = order * last;
      sum += last;
    }
    ASSERT_LT(last.cwiseAbs().maxCoeff(), 1e-6);
    const VectorXd found = matrix_of(level, m, kLost) * source;
    const double most = sum.cwiseAbs().maxCoeff();
    for (Index i = 0; i < sum.size(); ++i) {
      EXPECT_NEAR(found[i] / most, sum[i] / most, 5e-3) << "m " << m << ", unknown " << i << " of " << sum.size();
    }
  }
}

}  // namespace
}  // namespace airlight
