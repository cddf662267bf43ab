#include "slab.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/physics/gauss.h"

namespace airlight {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Reflection and transmission of a level layer, for the radiance at the nodes in one mode of azimuth.
struct SlabLayer {
  MatrixXd reflect;
  MatrixXd transmit;
};

// (1 - a)^-1 b: all bounces between two layers.
MatrixXd bounced(const MatrixXd& a, const MatrixXd& b) {
  return (MatrixXd::Identity(a.rows(), a.cols()) - a).partialPivLu().solve(b);
}

// A layer above another. Only light that leaves at its own top and light that arrives below both is kept.
SlabLayer over(const SlabLayer& upper, const SlabLayer& lower) {
  const MatrixXd arrives = bounced(upper.reflect * lower.reflect, upper.transmit);
  return {upper.reflect + upper.transmit * lower.reflect * arrives, lower.transmit * arrives};
}

// sqrt((l-m)!/(l+m)!) P_l^m(x) for l = m .. count-1, by recurrence in l.
VectorXd legendre(int m, int count, double x) {
  VectorXd y(count - m);
  double diagonal = 1.0;
  for (int k = 1; k <= m; ++k) {
    diagonal *= std::sqrt((2.0 * k - 1.0) / (2.0 * k)) * std::sqrt(1.0 - x * x);
  }
  double before = 0.0;
  double value = diagonal;
  for (int l = m; l < count; ++l) {
    y[l - m] = value;
    const double a = std::sqrt((l + 1.0) * (l + 1.0) - m * m);
    const double next = ((2.0 * l + 1.0) * x * value - std::sqrt(1.0 * l * l - 1.0 * m * m) * before) / a;
    before = value;
    value = next;
  }
  return y;
}

// A layer so thin that it scatters no light twice.
SlabLayer thin_layer(const SlabCase& slab, const VectorXd& nodes, const VectorXd& weights, int m, double depth) {
  const int count = static_cast<int>(slab.moments.size());
  MatrixXd y(count - m, nodes.size());
  for (Index i = 0; i < nodes.size(); ++i) {
    y.col(i) = legendre(m, count, nodes[i]);
  }
  VectorXd forward(count - m);
  VectorXd back(count - m);
  for (int l = m; l < count; ++l) {
    forward[l - m] = (2.0 * l + 1.0) * slab.moments[static_cast<std::size_t>(l)];
    back[l - m] = (l + m) % 2 == 0 ? forward[l - m] : -forward[l - m];
  }
  const VectorXd way = depth * nodes.cwiseInverse();
  const MatrixXd scattered = 0.5 * slab.single_scattering_albedo * way * weights.transpose();
  SlabLayer layer{scattered.cwiseProduct(y.transpose() * back.asDiagonal() * y),
                  scattered.cwiseProduct(y.transpose() * forward.asDiagonal() * y)};
  layer.transmit.diagonal() += VectorXd::Ones(way.size()) - way;
  return layer;
}

}  // namespace

std::vector<double> rayleigh_moments() {
  return {1.0, 0.0, 0.1};
}

std::vector<double> henyey_greenstein_moments(double g, int count) {
  std::vector<double> moments;
  for (int l = 0; l < count; ++l) {
    moments.push_back(std::pow(g, l));
  }
  return moments;
}

Slab::Slab(const SlabCase& slab, int nodes_per_hemisphere, int sun) {
  GaussRule rule = gauss_legendre(nodes_per_hemisphere);
  nodes_ = std::move(rule.nodes);
  weights_ = std::move(rule.weights);
  const auto n = static_cast<Index>(nodes_.size());
  const VectorXd nodes = Eigen::Map<VectorXd>(nodes_.data(), n);
  const VectorXd weights = Eigen::Map<VectorXd>(weights_.data(), n);
  constexpr int kDoublings = 32;
  for (int m = 0; m < static_cast<int>(slab.moments.size()); ++m) {
    SlabLayer layer = thin_layer(slab, nodes, weights, m, std::ldexp(slab.optical_depth, -kDoublings));
    for (int k = 0; k < kDoublings; ++k) {
      layer = over(layer, layer);
    }
    if (m == 0 && slab.ground_albedo > 0.0) {
      const VectorXd cosines = 2.0 * slab.ground_albedo * nodes.cwiseProduct(weights);
      layer = over(layer, {VectorXd::Ones(n) * cosines.transpose(), MatrixXd::Identity(n, n)});
    }
    // A beam of irradiance 1 is a radiance of (2 - delta_m0) / (2 pi w) in its node.
    const double beam = (m == 0 ? 1.0 : 2.0) / (2.0 * std::numbers::pi * weights[sun]);
    VectorXd up = layer.reflect.col(sun) * beam;
    VectorXd down = layer.transmit.col(sun) * beam;
    down[sun] -= std::exp(-slab.optical_depth / nodes[sun]) * beam;
    reflected_.emplace_back(up.begin(), up.end());
    transmitted_.emplace_back(down.begin(), down.end());
  }
}

double Slab::reflected(std::size_t i, double azimuth) const {
  double radiance = 0.0;
  for (std::size_t m = 0; m < reflected_.size(); ++m) {
    radiance += reflected_[m][i] * std::cos(static_cast<double>(m) * azimuth);
  }
  return radiance;
}

double Slab::transmitted(std::size_t i, double azimuth) const {
  double radiance = 0.0;
  for (std::size_t m = 0; m < transmitted_.size(); ++m) {
    radiance += transmitted_[m][i] * std::cos(static_cast<double>(m) * azimuth);
  }
  return radiance;
}

}  // namespace airlight
